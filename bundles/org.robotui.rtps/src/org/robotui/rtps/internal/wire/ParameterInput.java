package org.robotui.rtps.internal.wire;

import java.nio.ByteBuffer;

/** Goes through a parameter list. Padding is left out; what is not known is for the caller to skip. */
public final class ParameterInput {

  private static final int PAD = 0x0000;

  private static final int SENTINEL = 0x0001;

  /** Of XTypes: id and length follow with 32 bits each. */
  private static final int EXTENDED = 0x3f01;

  private static final int MUST_UNDERSTAND = 0x4000;

  private static final int VENDOR = 0x8000;

  private final ByteBuffer in;

  private int id;

  private ByteBuffer value;

  /**
   * Begins before the first parameter.
   *
   * @param in its position moves on, to behind the end of the list when there is no more; its byte order is that of the
   * list
   */
  public ParameterInput(ByteBuffer in) {
    this.in = in;
    this.value = in;
  }

  /** Moves to behind the end of a list. */
  static void skip(ByteBuffer in) throws WireException {
    ParameterInput parameters = new ParameterInput(in);
    while (parameters.next()) {
      // all are left out
    }
  }

  /**
   * Goes to the next parameter.
   *
   * @return false at the end of the list
   * @throws WireException if the list does not end, or a parameter reaches beyond it
   */
  public boolean next() throws WireException {
    int raw;
    do {
      if (in.remaining() < 4) {
        throw new WireException("a parameter list without an end");
      }
      raw = Short.toUnsignedInt(in.getShort());
      int length = Short.toUnsignedInt(in.getShort());
      if (raw == SENTINEL) {
        return false;
      }
      value = slice(raw, length);
    } while (raw == PAD);
    id = plain(raw);
    if (id == EXTENDED) {
      extended();
    }
    return true;
  }

  /** A flag that asks to understand a parameter is not part of its number; numbers of vendors are their own. */
  private static int plain(int raw) {
    return (raw & VENDOR) != 0 ? raw : raw & ~MUST_UNDERSTAND;
  }

  private ByteBuffer slice(int parameter, long length) throws WireException {
    if (length > in.remaining()) {
      throw new WireException("parameter 0x%04x has %d bytes, here are %d".formatted(parameter, length,
          in.remaining()));
    }
    ByteBuffer part = in.slice(in.position(), (int) length).order(in.order());
    in.position(in.position() + (int) length);
    return part;
  }

  private void extended() throws WireException {
    WireInput.need(value, 8, "a long parameter");
    long number = Integer.toUnsignedLong(value.getInt());
    value = slice(EXTENDED, Integer.toUnsignedLong(value.getInt()));
    id = number > 0x3fff ? EXTENDED : (int) number;
  }

  /** The number of the parameter. */
  public int id() {
    return id;
  }

  /** Its value, in the byte order of the list; see {@link ParameterValue}. */
  public ByteBuffer value() {
    return value;
  }
}
