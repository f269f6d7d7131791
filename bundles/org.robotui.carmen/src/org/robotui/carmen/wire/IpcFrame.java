package org.robotui.carmen.wire;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * One message on its way.
 *
 * @param parent of which another message was the reason; -1 for none
 * @param intent the number of the message towards a central, of the handler towards a module, or one of the words below
 * @param kind what the message is for
 * @param dispatch of a reply or a completion, the reference of what it answers; else -1
 * @param reference by which replies and completions name it; -1 where there are none
 * @param name of the message, where the frame says it; else empty
 * @param order of the bytes of name and body
 * @param body the data
 */
public record IpcFrame(int parent, int intent, int kind, int dispatch, int reference, String name, ByteOrder order,
    ByteBuffer body) {

  /** The intent of replies and completions that a module sends through a central. */
  public static final int TO_CENTRAL = -1;
  /** The intent of replies that a central sends, and of those between modules. */
  public static final int REPLY_INTENT = -4;
  /** What a central answers for itself. */
  public static final int SYSTEM = 0;
  /** A question, which is answered. */
  public static final int QUERY = 3;
  /** What a central is told. */
  public static final int INFORM = 6;
  /** An answer of a module. */
  public static final int REPLY = 0x0b;
  /** Says that a message was handled. */
  public static final int COMPLETION = 0x0c;
  /** For all who handle it. */
  public static final int BROADCAST = 0x0f;

  /** No message that another was the reason for, and no reference. */
  public static final int NONE = -1;

  /** Takes the body as it is, from its position to its limit. */
  public IpcFrame {
    body = body.slice().asReadOnlyBuffer().order(order);
  }

  /**
   * A message with little endian bytes, as programs on today's machines send them.
   *
   * @param intent its number
   * @param kind what it is for
   * @param reference by which it is answered
   * @param body its data
   * @return without a parent or a name
   */
  public static IpcFrame of(int intent, int kind, int reference, byte[] body) {
    return new IpcFrame(NONE, intent, kind, NONE, reference, "", ByteOrder.LITTLE_ENDIAN, ByteBuffer.wrap(body));
  }

  /**
   * The data.
   *
   * @return a view of its own, in the order of its bytes
   */
  @Override
  public ByteBuffer body() {
    return body.duplicate().order(order);
  }
}
