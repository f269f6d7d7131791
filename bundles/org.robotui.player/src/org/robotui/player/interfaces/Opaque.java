package org.robotui.player.interfaces;

import org.robotui.player.layout.Kind;

/** Bytes that only a client and its driver understand. The interface {@code opaque}. */
public final class Opaque {

  /** Data: state. */
  public static final Kind.Data<Bytes> STATE = new Kind.Data<>("opaque", "state", Bytes.class);

  /** Command: send. */
  public static final Kind.Command<Bytes> SEND = new Kind.Command<>("opaque", "send", Bytes.class);

  /** Request: ask with {@link Bytes}; answered by {@link Bytes}. */
  public static final Kind.Request<Bytes, Bytes> ASK = new Kind.Request<>("opaque", "ask", Bytes.class, Bytes.class);

  private Opaque() {}

  /**
   * In the driver's own language.
   *
   * @param data the bytes
   */
  public record Bytes(byte[] data) {}
}
