package org.robotui.rtps.internal.wire;

/** The numbers of the submessages, and the bits of their flags. */
final class SubmessageId {

  static final int PAD = 0x01;
  static final int ACKNACK = 0x06;
  static final int HEARTBEAT = 0x07;
  static final int GAP = 0x08;
  static final int INFO_TS = 0x09;
  static final int INFO_SRC = 0x0c;
  static final int INFO_REPLY_IP4 = 0x0d;
  static final int INFO_DST = 0x0e;
  static final int INFO_REPLY = 0x0f;
  static final int NACK_FRAG = 0x12;
  static final int HEARTBEAT_FRAG = 0x13;
  static final int DATA = 0x15;
  static final int DATA_FRAG = 0x16;

  /** Set in all: little-endian. */
  static final int LITTLE = 0x01;

  /** Of heartbeats and acknowledgements. */
  static final int FINAL = 0x02;
  static final int LIVELINESS = 0x04;

  /** Of samples. */
  static final int INLINE_QOS = 0x02;
  static final int SAMPLE = 0x04;
  static final int KEY = 0x08;
  static final int NOT_STANDARD = 0x10;
  static final int FRAG_KEY = 0x04;
  static final int FRAG_NOT_STANDARD = 0x08;

  /** Of times: there is none. */
  static final int NO_TIME = 0x02;

  /** Of places for answers: there are groups, too. */
  static final int MULTICAST = 0x02;

  private SubmessageId() {}

  static String name(int id) {
    return switch (id) {
      case PAD -> "PAD";
      case ACKNACK -> "ACKNACK";
      case HEARTBEAT -> "HEARTBEAT";
      case GAP -> "GAP";
      case INFO_TS -> "INFO_TS";
      case INFO_SRC -> "INFO_SRC";
      case INFO_REPLY_IP4 -> "INFO_REPLY_IP4";
      case INFO_DST -> "INFO_DST";
      case INFO_REPLY -> "INFO_REPLY";
      case NACK_FRAG -> "NACK_FRAG";
      case HEARTBEAT_FRAG -> "HEARTBEAT_FRAG";
      case DATA -> "DATA";
      case DATA_FRAG -> "DATA_FRAG";
      default -> "submessage 0x%02x".formatted(id);
    };
  }
}
