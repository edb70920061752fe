-- The catalogue of clips, version 1. docs/library.md, "The database", says what every column means.

-- The folders that the user pointed at.
CREATE TABLE folder (
    id INTEGER PRIMARY KEY,
    path TEXT NOT NULL UNIQUE,
    added_at INTEGER NOT NULL,
    scanned_at INTEGER
) STRICT;

-- A file. What people say of it (subject to cleaned) is the value in force: see `told`.
CREATE TABLE clip (
    id INTEGER PRIMARY KEY,
    folder_id INTEGER NOT NULL REFERENCES folder (id) ON DELETE CASCADE DEFERRABLE INITIALLY DEFERRED,
    path TEXT NOT NULL UNIQUE,
    name TEXT NOT NULL,
    folder TEXT NOT NULL,
    size INTEGER NOT NULL,
    modified_ns INTEGER NOT NULL,
    content_hash BLOB CHECK (length(content_hash) = 32),
    format TEXT NOT NULL,
    frames INTEGER,
    first_frame INTEGER,
    rate_hz REAL,
    duration_s REAL,
    joints INTEGER,
    markers INTEGER,
    skeleton_fingerprint TEXT,
    height_m REAL,
    unit_m REAL,
    up TEXT,
    skeleton_path TEXT,
    skeleton_reason TEXT,
    subject TEXT,
    recorded_on TEXT,
    description TEXT,
    session_group TEXT,
    cleaned INTEGER CHECK (cleaned IN (0, 1)),
    rating INTEGER NOT NULL DEFAULT 0 CHECK (rating BETWEEN 0 AND 5),
    is_favourite INTEGER NOT NULL DEFAULT 0 CHECK (is_favourite IN (0, 1)),
    used_at INTEGER,
    notices TEXT NOT NULL DEFAULT '[]',
    error TEXT,
    is_missing INTEGER NOT NULL DEFAULT 0 CHECK (is_missing IN (0, 1)),
    facts_at INTEGER NOT NULL,
    facts_by INTEGER NOT NULL
) STRICT;

CREATE INDEX clip_folder ON clip (folder_id);
CREATE INDEX clip_content ON clip (content_hash);

-- What searches go through, in the order of the names: all that numbers, dates and flags of a query ask for, and all that
-- clips are sorted by. A search reads these rows and not those of `clip`, which are five times as long.
CREATE INDEX clip_facts ON clip (
    name COLLATE NOCASE, id, format, frames, rate_hz, duration_s, joints, markers, height_m, recorded_on, cleaned, rating,
    is_favourite, is_missing, size, modified_ns, used_at
);
CREATE INDEX clip_subject ON clip (subject);
CREATE INDEX clip_group ON clip (session_group);
CREATE INDEX clip_skeleton ON clip (skeleton_fingerprint, skeleton_path);
CREATE INDEX clip_described ON clip (id) WHERE description > '';
CREATE INDEX clip_broken ON clip (id) WHERE error IS NOT NULL;

-- What each source says of a clip. The order of trust is USER, SIDECAR, INDEX, FILE.
CREATE TABLE told (
    clip_id INTEGER NOT NULL REFERENCES clip (id) ON DELETE CASCADE,
    source TEXT NOT NULL CHECK (source IN ('FILE', 'INDEX', 'SIDECAR', 'USER')),
    field TEXT NOT NULL CHECK (field IN ('subject', 'recorded_on', 'description', 'session_group', 'cleaned')),
    value TEXT NOT NULL,
    PRIMARY KEY (clip_id, field, source)
) STRICT, WITHOUT ROWID;

-- The sidecars that were read, and what the disk listed of them then.
CREATE TABLE sidecar (
    path TEXT PRIMARY KEY,
    size INTEGER NOT NULL,
    modified_ns INTEGER NOT NULL
) STRICT, WITHOUT ROWID;

CREATE TABLE tag (
    id INTEGER PRIMARY KEY,
    name TEXT NOT NULL COLLATE NOCASE UNIQUE
) STRICT;

CREATE TABLE clip_tag (
    clip_id INTEGER NOT NULL REFERENCES clip (id) ON DELETE CASCADE,
    tag_id INTEGER NOT NULL REFERENCES tag (id) ON DELETE CASCADE,
    PRIMARY KEY (clip_id, tag_id)
) STRICT, WITHOUT ROWID;

CREATE INDEX clip_tag_by_tag ON clip_tag (tag_id, clip_id);

-- The usable pieces of a clip, in the file's own frame numbers.
CREATE TABLE segment (
    clip_id INTEGER NOT NULL REFERENCES clip (id) ON DELETE CASCADE,
    first_frame INTEGER NOT NULL,
    last_frame INTEGER NOT NULL CHECK (last_frame >= first_frame),
    note TEXT NOT NULL DEFAULT '',
    PRIMARY KEY (clip_id, first_frame, last_frame)
) STRICT, WITHOUT ROWID;

-- The words by which clips are found. Only the index is kept: the texts are those of `clip_words`.
CREATE VIRTUAL TABLE clip_text USING fts5 (
    name, folder, subject, description, session_group, tags,
    content = '', contentless_delete = 1, prefix = '1 2 3', tokenize = 'unicode61 remove_diacritics 2'
);

CREATE VIEW clip_words AS
SELECT id, name, folder, subject, description, session_group,
    -- Between two tags a character for private use, a word of its own: no phrase runs from one tag into the next.
    (SELECT group_concat(tag.name, ' ' || char(0xE000) || ' ') FROM clip_tag JOIN tag ON tag.id = tag_id
     WHERE clip_id = clip.id) AS tags
FROM clip;

CREATE TRIGGER clip_added AFTER INSERT ON clip BEGIN
    INSERT INTO clip_text (rowid, name, folder, subject, description, session_group, tags)
    VALUES (new.id, new.name, new.folder, new.subject, new.description, new.session_group, NULL);
END;

CREATE TRIGGER clip_removed AFTER DELETE ON clip BEGIN
    DELETE FROM clip_text WHERE rowid = old.id;
END;

CREATE TRIGGER clip_renamed AFTER UPDATE OF name, folder, subject, description, session_group ON clip
WHEN (new.name, new.folder, new.subject, new.description, new.session_group)
    IS NOT (old.name, old.folder, old.subject, old.description, old.session_group)
BEGIN
    DELETE FROM clip_text WHERE rowid = new.id;
    INSERT INTO clip_text (rowid, name, folder, subject, description, session_group, tags)
    SELECT * FROM clip_words WHERE id = new.id;
END;

CREATE TRIGGER tag_put_on AFTER INSERT ON clip_tag BEGIN
    DELETE FROM clip_text WHERE rowid = new.clip_id;
    INSERT INTO clip_text (rowid, name, folder, subject, description, session_group, tags)
    SELECT * FROM clip_words WHERE id = new.clip_id;
END;

CREATE TRIGGER tag_taken_off AFTER DELETE ON clip_tag BEGIN
    DELETE FROM clip_text WHERE rowid = old.clip_id;
    INSERT INTO clip_text (rowid, name, folder, subject, description, session_group, tags)
    SELECT * FROM clip_words WHERE id = old.clip_id;
END;
