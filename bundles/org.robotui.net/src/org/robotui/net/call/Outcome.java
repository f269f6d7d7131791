package org.robotui.net.call;

import java.time.Duration;
import java.util.Optional;
import java.util.function.Function;

/**
 * How a call to a peer ended.
 *
 * @param <T> what a successful call answers
 */
public sealed interface Outcome<T> {

  /**
   * The peer did it.
   *
   * @param value its answer
   * @param <T> the answer's type
   */
  record Done<T>(T value) implements Outcome<T> {}

  /**
   * The peer understood the call and said no.
   *
   * @param reason the peer's words, for a user to read
   * @param <T> the type of the answer that did not come
   */
  record Refused<T>(String reason) implements Outcome<T> {}

  /**
   * The peer was not reached, or what it sent is no valid answer.
   *
   * @param reason names the peer and the cause, for a user to read
   * @param <T> the type of the answer that did not come
   */
  record Failed<T>(String reason) implements Outcome<T> {}

  /**
   * The peer did not answer in time; it may still act on the call.
   *
   * @param reason names the peer
   * @param after how long the caller waited
   * @param <T> the type of the answer that did not come
   */
  record TimedOut<T>(String reason, Duration after) implements Outcome<T> {}

  /**
   * The answer, if there is one.
   *
   * @return the value of {@link Done}, else empty
   */
  default Optional<T> toOptional() {
    return this instanceof Done<T> done ? Optional.of(done.value()) : Optional.empty();
  }

  /**
   * Why there is no answer.
   *
   * @return the reason, or an empty string for {@link Done}
   */
  default String reason() {
    return switch (this) {
      case Done<T> done -> "";
      case Refused<T> refused -> refused.reason();
      case Failed<T> failed -> failed.reason();
      case TimedOut<T> late -> late.reason();
    };
  }

  /**
   * The same outcome with another answer.
   *
   * @param function turns the answer into the new one
   * @param <U> the new answer's type
   * @return {@link Done} of the new answer, or this failure
   */
  default <U> Outcome<U> map(Function<? super T, ? extends U> function) {
    return switch (this) {
      case Done<T> done -> new Done<>(function.apply(done.value()));
      case Refused<T> refused -> new Refused<>(refused.reason());
      case Failed<T> failed -> new Failed<>(failed.reason());
      case TimedOut<T> late -> new TimedOut<>(late.reason(), late.after());
    };
  }
}
