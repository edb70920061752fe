CREATE TABLE IF NOT EXISTS preview (
    content_hash BLOB PRIMARY KEY,      -- of the file that it shows, wherever that lies
    made_by INTEGER NOT NULL,           -- version of the drawing; of another one, it is made anew
    frame INTEGER NOT NULL,             -- of the still, as the file numbers it
    width INTEGER NOT NULL,             -- of one picture, in pixels
    height INTEGER NOT NULL,
    still BLOB NOT NULL,                -- PNG
    strip BLOB NOT NULL,                -- PNG, frames side by side
    strip_frames INTEGER NOT NULL,
    strip_rate_hz REAL NOT NULL,
    used_at INTEGER NOT NULL            -- seconds since 1970, to the hour
);
CREATE INDEX IF NOT EXISTS preview_by_use ON preview (used_at);
