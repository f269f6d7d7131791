package org.robotui.recording;

/**
 * A file that lies in a recording.
 *
 * @param name as in the recording; no path to be trusted
 * @param mediaType such as {@code text/plain}; may be empty
 * @param logTime when it was recorded, nanoseconds since 1970
 * @param createTime when it was made, nanoseconds since 1970; 0 where that is not known
 * @param size how many bytes it has: {@link RecordingReader#content} reads them
 * @param offset where its record begins in the recording
 */
public record RecordedAttachment(String name, String mediaType, long logTime, long createTime, long size,
    long offset) {}
