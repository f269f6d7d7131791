package org.robotui.recording.internal.chunk;

import java.nio.ByteBuffer;
import org.robotui.recording.RecordedAttachment;
import org.robotui.recording.RecordingException;

/** Reads from a file of some format what its index tells of. */
public interface ChunkSource {

  /** The messages of a chunk; of a damaged one those that are whole. It tells the damage. */
  LoadedChunk load(ChunkRef chunk) throws RecordingException;

  /** Whether the chunk that was loaded last was compressed. */
  default boolean decompresses() {
    return false;
  }

  /** The bytes of a file that lies in the recording. */
  ByteBuffer content(RecordedAttachment attachment) throws RecordingException;
}
