package org.robotui.recording.internal.bag;

import org.robotui.recording.RecordingException;
import org.robotui.recording.internal.io.ByteWindow;
import org.robotui.recording.internal.io.FileBytes;
import org.robotui.recording.internal.io.MalformedRecord;
import org.robotui.recording.internal.io.PackedFields;

/**
 * Where a record lies in the file.
 *
 * @param data where its data begin
 * @param length what it says that its data have; the file may end before
 */
record BagRecord(BagFields header, long data, long length) {

  static BagRecord at(long offset, FileBytes file, ByteWindow window) throws RecordingException, MalformedRecord {
    long left = file.size() - offset;
    long header = left < Integer.BYTES ? -1 : window.u32(offset);
    if (header < 0 || header > BagFields.MOST_HEADER || header > left - 2 * Integer.BYTES) {
      throw new MalformedRecord(header < 0 ? "the file ends in a record"
          : "a record has a header of " + header + " bytes where " + left + " are left");
    }
    byte[] bytes = file.read(offset + Integer.BYTES, (int) header);
    long data = offset + Integer.BYTES + header;
    return new BagRecord(new BagFields(new PackedFields(bytes, 0, bytes.length)), data + Integer.BYTES,
        window.u32(data));
  }

  long end() {
    return data + length;
  }
}
