package org.robotui.rtps.internal.wire;

/** Takes the parts of messages. */
@FunctionalInterface
public interface MessageHandler {

  /**
   * A part came.
   *
   * @param context what is said about it; good until this returns
   * @param part its buffers are views of the datagram
   */
  void onPart(MessageContext context, Submessage.Exchanged part);
}
