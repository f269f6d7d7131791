package org.robotui.smartsoft.wire;

import java.util.Optional;

/** What components say to each other. The order is that of the numbers on the wire. */
public enum SmartCommand {
  /** To a server: number of the client, identifier of the service. */
  CONNECT,
  /** Number of the client, status. */
  ACK_CONNECT,
  /** To a server: the client is gone. */
  DISCARD,
  /** To a server. */
  DISCONNECT,
  /** It was taken. */
  ACK_DISCONNECT,
  /** A server ends: number of the client. */
  SERVER_INITIATED_DISCONNECT,
  /** Send: the object. */
  COMMAND,
  /** Query: number of the query; the request. */
  REQUEST,
  /** Query: number of the query; the answer. */
  ANSWER,
  /** Push: number of the subscription; the object. */
  UPDATE,
  /** Push: every n-th update is wanted; number of the subscription. */
  SUBSCRIBE,
  /** Push: whether the server is active. */
  ACK_SUBSCRIBE,
  /** Push: no more updates are wanted. */
  UNSUBSCRIBE,
  /** Push timed: what is the period of the server? */
  GET_SERVER_INFO,
  /** Push timed: period, and whether the server is active. */
  SERVER_INFO,
  /** Push timed: whether the server is active from now on. */
  ACTIVATION_STATE,
  /** Event: number of the activation; the event. */
  EVENT,
  /** Event: mode, number of the activation; the parameter. */
  ACTIVATE,
  /** Event: number of the activation. */
  ACK_ACTIVATE,
  /** Event: number of the activation. */
  DEACTIVATE;

  /**
   * The number on the wire.
   *
   * @return from 0
   */
  public int number() {
    return ordinal();
  }

  /**
   * The command of a number.
   *
   * @param number on the wire
   * @return empty for one that is not known
   */
  public static Optional<SmartCommand> of(int number) {
    return number >= 0 && number < values().length ? Optional.of(values()[number]) : Optional.empty();
  }
}
