package org.robotui.recording.internal.mcap;

/** Words of the format. Source: the specification of MCAP, mcap.dev/spec. */
final class McapFormat {

  static final int HEADER = 0x01;
  static final int FOOTER = 0x02;
  static final int SCHEMA = 0x03;
  static final int CHANNEL = 0x04;
  static final int MESSAGE = 0x05;
  static final int CHUNK = 0x06;
  static final int MESSAGE_INDEX = 0x07;
  static final int CHUNK_INDEX = 0x08;
  static final int ATTACHMENT = 0x09;
  static final int ATTACHMENT_INDEX = 0x0a;
  static final int STATISTICS = 0x0b;
  static final int METADATA = 0x0c;
  static final int METADATA_INDEX = 0x0d;
  static final int SUMMARY_OFFSET = 0x0e;
  static final int DATA_END = 0x0f;

  /** What stands before the content of each record: its code and its length. */
  static final int RECORD_HEAD = 9;

  /** Of a message, before its bytes. */
  static final int MESSAGE_HEAD = 22;

  /** The footer with its head. */
  static final int FOOTER_LENGTH = RECORD_HEAD + 20;

  private static final byte[] MAGIC = {(byte) 0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};

  private McapFormat() {}

  static byte[] magic() {
    return MAGIC.clone();
  }

  /** Records that are read at once, but for chunks and attachments. */
  static final int MOST_RECORD = 16 << 20;
}
