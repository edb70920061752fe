"""What time it is on the stage. Playback goes by time, so its speed stays true however seldom the window is drawn."""

from __future__ import annotations

from dataclasses import dataclass

SPEEDS = (0.1, 0.25, 0.5, 1.0, 2.0, 4.0)


@dataclass
class Clock:
    """Seconds since the beginning of the clips that play. `now` is always a monotonic time in seconds."""

    duration_s: float = 0.0
    """Where playback begins anew."""
    start_s: float = 0.0
    """Where playback begins: the in mark of a single clip."""
    speed: float = 1.0
    is_playing: bool = False
    _position_s: float = 0.0
    _since: float = 0.0

    def position(self, now: float) -> float:
        """Return the seconds since the beginning, between start and duration while it plays."""
        if not self.is_playing:
            return self._position_s
        passed = self._position_s + (now - self._since) * self.speed
        length = self.duration_s - self.start_s
        if length <= 0.0:
            return self.start_s
        return passed if passed < self.duration_s else self.start_s + (passed - self.start_s) % length

    def play(self, now: float) -> None:
        """Go on from where it stands; from the start where it stands at the end or before the start."""
        if not self.start_s <= self._position_s < self.duration_s:
            self._position_s = self.start_s
        self._since, self.is_playing = now, True

    def pause(self, now: float) -> None:
        """Stay where it is."""
        self._position_s, self.is_playing = self.position(now), False

    def toggle(self, now: float) -> None:
        """Play or pause."""
        if self.is_playing:
            self.pause(now)
        else:
            self.play(now)

    def stop(self) -> None:
        """Return to the beginning, at rest."""
        self._position_s, self.is_playing = self.start_s, False

    def scrub(self, position_s: float, now: float) -> None:
        """Go to a time, and go on playing from there if it plays."""
        self._position_s, self._since = max(0.0, position_s), now

    def step(self, seconds: float, now: float) -> None:
        """Pause, and go some time on or back, no further than to the ends."""
        self.pause(now)
        self._position_s = min(max(self._position_s + seconds, 0.0), self.duration_s)

    def set_speed(self, speed: float, now: float) -> None:
        """Play faster or slower from now on."""
        self.scrub(self.position(now), now)
        self.speed = speed

    def faster(self, steps: int, now: float) -> None:
        """Go up or down in the list of speeds."""
        nearest = min(range(len(SPEEDS)), key=lambda number: abs(SPEEDS[number] - self.speed))
        self.set_speed(SPEEDS[min(max(nearest + steps, 0), len(SPEEDS) - 1)], now)


def frame_at(position_s: float, frames: int, rate_hz: float) -> float:
    """Return the frame of a clip, counted from 0 with a fraction; a clip that is over begins anew."""
    if frames <= 1 or rate_hz <= 0.0:
        return 0.0
    return min(position_s * rate_hz % frames, frames - 1.0)


def seconds(frames: int, rate_hz: float) -> float:
    """Return how long a clip plays."""
    return max(0, frames - 1) / rate_hz if rate_hz > 0.0 else 0.0
