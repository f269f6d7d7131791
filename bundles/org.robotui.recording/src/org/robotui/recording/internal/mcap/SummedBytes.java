package org.robotui.recording.internal.mcap;

import java.nio.ByteBuffer;
import java.util.zip.CRC32;

/**
 * Bytes with their checksum.
 *
 * @param bytes from position to limit
 * @param sum CRC-32
 */
record SummedBytes(ByteBuffer bytes, int sum) {
  static SummedBytes of(ByteBuffer bytes) {
    CRC32 crc = new CRC32();
    crc.update(bytes.duplicate());
    return new SummedBytes(bytes, (int) crc.getValue());
  }
}
