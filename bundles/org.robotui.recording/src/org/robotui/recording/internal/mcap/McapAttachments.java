package org.robotui.recording.internal.mcap;

import org.robotui.recording.RecordedAttachment;
import org.robotui.recording.RecordedMetadata;
import org.robotui.recording.RecordingException;
import org.robotui.recording.internal.io.FileBytes;
import org.robotui.recording.internal.io.MalformedRecord;
import org.robotui.recording.internal.io.PackedFields;

/** Records beside messages: files and notes. */
final class McapAttachments {

  private McapAttachments() {}

  /** The length of the record at a place, bounded by the file. */
  static long length(FileBytes file, long offset) throws RecordingException {
    byte[] head = file.read(offset, McapFormat.RECORD_HEAD);
    PackedFields fields = new PackedFields(head, 1, head.length);
    try {
      long length = fields.size("the length of a record");
      if (length <= file.size() - offset - McapFormat.RECORD_HEAD) {
        return length;
      }
      throw new MalformedRecord("a record has " + length + " bytes, and the file ends before");
    } catch (MalformedRecord e) {
      throw new RecordingException(file.path(), offset, e.getMessage());
    }
  }

  /** Reads up to the content. */
  static RecordedAttachment of(PackedFields fields, long offset) throws MalformedRecord {
    long logTime = fields.i64("the log time of an attachment");
    long createTime = fields.i64("the time of an attachment");
    String name = fields.text("the name of an attachment");
    String type = fields.text("the type of an attachment");
    return new RecordedAttachment(name, type, logTime, createTime, fields.size("the size of an attachment"), offset);
  }

  /** Reads an entry of the index, which has the same fields in another order. */
  static RecordedAttachment ofIndex(PackedFields fields) throws MalformedRecord {
    long offset = fields.size("the place of an attachment");
    fields.size("the length of an attachment");
    long logTime = fields.i64("the log time of an attachment");
    long createTime = fields.i64("the time of an attachment");
    long size = fields.size("the size of an attachment");
    String name = fields.text("the name of an attachment");
    return new RecordedAttachment(name, fields.text("the type of an attachment"), logTime, createTime, size, offset);
  }

  static RecordedMetadata metadata(PackedFields fields) throws MalformedRecord {
    String name = fields.text("the name of metadata");
    return new RecordedMetadata(name, fields.texts("the metadata " + name));
  }
}
