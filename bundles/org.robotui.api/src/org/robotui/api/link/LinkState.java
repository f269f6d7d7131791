package org.robotui.api.link;

import java.time.Duration;

/** How a robot interface and its robot are connected. Connected alone does not mean that data comes. */
public sealed interface LinkState {
  /**
   * One word for users, for example {@code connected}.
   *
   * @return the word
   */
  String word();

  /**
   * A sentence for users, empty where the word says all.
   *
   * @return the reason
   */
  String reason();

  /** Nothing was tried yet, or it was ended on purpose. */
  record Disconnected() implements LinkState {
    @Override
    public String word() {
      return "disconnected";
    }

    @Override
    public String reason() {
      return "";
    }
  }

  /**
   * A connection is being made.
   *
   * @param peer who is called
   */
  record Connecting(String peer) implements LinkState {
    @Override
    public String word() {
      return "connecting";
    }

    @Override
    public String reason() {
      return "calling " + peer;
    }
  }

  /**
   * The peer answers and everything wanted is there.
   *
   * @param peer who answers
   */
  record Connected(String peer) implements LinkState {
    @Override
    public String word() {
      return "connected";
    }

    @Override
    public String reason() {
      return "";
    }
  }

  /**
   * The peer answers, but not everything wanted works: a wrong type, a topic without publisher.
   *
   * @param peer who answers
   * @param reason what does not work
   */
  record Degraded(String peer, String reason) implements LinkState {
    @Override
    public String word() {
      return "degraded";
    }
  }

  /**
   * No connection; it will be tried again.
   *
   * @param reason names peer and cause
   * @param retryIn until the next attempt
   */
  record Failed(String reason, Duration retryIn) implements LinkState {
    @Override
    public String word() {
      return "retry " + Math.max(1, retryIn.toSeconds()) + " s";
    }
  }
}
