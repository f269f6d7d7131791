package org.robotui.player.layout;

import org.robotui.player.wire.MessageType;

/** Names a message of an interface together with the Java record of its body. */
public sealed interface Kind {

  /**
   * The interface's name.
   *
   * @return such as {@code position2d}; {@code any} for messages of all interfaces
   */
  String on();

  /**
   * The message's name.
   *
   * @return as the layout has it
   */
  String message();

  /**
   * The type on the wire.
   *
   * @return DATA, COMMAND or REQUEST
   */
  MessageType wireType();

  /**
   * Measurements.
   *
   * @param on the interface
   * @param message the message
   * @param type the record of its body
   * @param <T> the record
   */
  record Data<T>(String on, String message, Class<T> type) implements Kind {
    @Override
    public MessageType wireType() {
      return MessageType.DATA;
    }
  }

  /**
   * A command.
   *
   * @param on the interface
   * @param message the message
   * @param type the record of its body
   * @param <T> the record
   */
  record Command<T>(String on, String message, Class<T> type) implements Kind {
    @Override
    public MessageType wireType() {
      return MessageType.COMMAND;
    }
  }

  /**
   * A request and its answer.
   *
   * @param on the interface
   * @param message the message
   * @param asked the record of the question
   * @param answer the record of the answer
   * @param <Q> the question
   * @param <A> the answer
   */
  record Request<Q, A>(String on, String message, Class<Q> asked, Class<A> answer) implements Kind {
    @Override
    public MessageType wireType() {
      return MessageType.REQUEST;
    }
  }
}
