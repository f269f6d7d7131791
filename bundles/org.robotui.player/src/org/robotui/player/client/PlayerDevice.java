package org.robotui.player.client;

import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.robotui.net.call.Outcome;
import org.robotui.player.internal.client.DeviceLink;
import org.robotui.player.layout.Codec;
import org.robotui.player.layout.Kind;
import org.robotui.player.layout.Layouts;
import org.robotui.player.layout.MessageLayout;
import org.robotui.player.layout.PlayerRecord;
import org.robotui.player.wire.DeviceAddress;
import org.robotui.player.wire.DeviceId;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;

/**
 * One device of a server. Any thread may use it, and no call blocks. The futures of requests are completed on the
 * client's threads: what depends on them must not block.
 */
public final class PlayerDevice {

  private final DeviceLink link;
  private final Layouts layouts;

  PlayerDevice(DeviceLink link) {
    this.link = link;
    this.layouts = link.client().layouts();
  }

  /**
   * Which device it is.
   *
   * @return interface and index
   */
  public DeviceId id() {
    return link.id();
  }

  /**
   * The device as people write it.
   *
   * @return such as {@code position2d:0}
   */
  public String name() {
    return link.name();
  }

  /**
   * The device's address as the server writes it.
   *
   * @return empty while there is no link
   */
  public Optional<DeviceAddress> address() {
    return link.address();
  }

  /**
   * What became of the subscription.
   *
   * @return the present state
   */
  public DeviceState state() {
    return link.state();
  }

  /**
   * Opens the device, and keeps it open over any loss of the link.
   *
   * @param listener hears of data and state, at once of the present one
   * @return to be closed
   */
  public Subscription subscribe(DeviceListener listener) {
    return link.subscribe(listener);
  }

  /**
   * Opens the device and listens to one kind of its data.
   *
   * @param kind the kind
   * @param listener hears of the data
   * @param <T> the record of the data
   * @return to be closed
   */
  public <T> Subscription subscribe(Kind.Data<T> kind, DataListener<T> listener) {
    Codec<T> codec = layouts.codec(kind);
    int subtype = layouts.message(kind).subtype();
    return link.subscribe((message, receiveNanos) -> {
      if (message.subtype() == subtype) {
        read(codec, message, receiveNanos, listener);
      }
    });
  }

  private <T> void read(Codec<T> codec, PlayerMessage message, long receiveNanos, DataListener<T> listener) {
    T value;
    try {
      value = codec.decode(message.payload());
    } catch (PlayerException e) {
      listener.onProblem(problem(e));
      return;
    }
    listener.onData(value, message.stamp(), receiveNanos);
  }

  /**
   * Commands the device. What waits for the network is replaced by newer commands of the same kind; nothing is kept for
   * a later link.
   *
   * @param kind the kind of command
   * @param value the command
   * @param <T> the command's record
   * @return false if the device is not open
   */
  public <T> boolean command(Kind.Command<T> kind, T value) {
    return link.command(layouts.message(kind).subtype(), layouts.codec(kind).encode(value));
  }

  /**
   * Commands the device whether or not it is open: servers hand on commands of clients that have not opened a device,
   * and start no driver for it. For a stop, which must open nothing.
   *
   * @param kind the kind of command
   * @param value the command
   * @param <T> the command's record
   * @return false if there is no link
   */
  public <T> boolean commandUnopened(Kind.Command<T> kind, T value) {
    return link.commandUnopened(layouts.message(kind).subtype(), layouts.codec(kind).encode(value));
  }

  /**
   * Closes the device and opens it again, where it is open, for a server that has stopped sending its data. A driver
   * that nobody else has open restarts. Listeners hear of it only where it is refused.
   */
  public void reopen() {
    link.reopen();
  }

  /**
   * Commands the device by a record.
   *
   * @param message the command
   * @param value its body; ignored if it has none
   * @return false if the device is not open
   */
  public boolean command(MessageLayout message, PlayerRecord value) {
    return link.command(message.subtype(), body(message, value));
  }

  /**
   * Asks the device.
   *
   * @param kind the kind of request
   * @param question the question
   * @param <Q> the question's record
   * @param <A> the answer's record
   * @return the answer, or why there is none; never fails otherwise
   */
  public <Q, A> CompletableFuture<Outcome<A>> request(Kind.Request<Q, A> kind, Q question) {
    Codec<A> answers = layouts.answer(kind);
    // some drivers return the question where nothing is to be answered
    boolean empty = layouts.message(kind).answer().isEmpty();
    return link.request(layouts.message(kind).subtype(), layouts.question(kind).encode(question), kind.message())
        .thenApply(
            outcome -> decoded(outcome, message -> answers.decode(empty ? ByteBuffer.allocate(0) : message.payload())));
  }

  /**
   * Asks the device by a record.
   *
   * @param message the request
   * @param question its body; ignored if it has none
   * @return the answer, or why there is none; never fails otherwise
   */
  public CompletableFuture<Outcome<PlayerRecord>> request(MessageLayout message, PlayerRecord question) {
    return link.request(message.subtype(), body(message, question), message.name())
        .thenApply(outcome -> decoded(outcome, layouts::decode));
  }

  /**
   * Asks the device by bytes, for messages that have no layout.
   *
   * @param subtype which request
   * @param question its body
   * @return the answer as it came, or why there is none; never fails otherwise
   */
  public CompletableFuture<Outcome<PlayerMessage>> request(int subtype, ByteBuffer question) {
    return link.request(subtype, question, "request " + subtype);
  }

  private ByteBuffer body(MessageLayout message, PlayerRecord value) {
    return message.payload().isEmpty() ? ByteBuffer.allocate(0) : layouts.encode(value);
  }

  /** Reads an answer. */
  private interface Decoder<A> {

    A decode(PlayerMessage message) throws PlayerException;
  }

  private <A> Outcome<A> decoded(Outcome<PlayerMessage> outcome, Decoder<A> decoder) {
    return switch (outcome) {
      case Outcome.Done<PlayerMessage> done -> decoded(done.value(), decoder);
      case Outcome.Refused<PlayerMessage> refused -> new Outcome.Refused<>(refused.reason());
      case Outcome.Failed<PlayerMessage> failed -> new Outcome.Failed<>(failed.reason());
      case Outcome.TimedOut<PlayerMessage> late -> new Outcome.TimedOut<>(late.reason(), late.after());
    };
  }

  private <A> Outcome<A> decoded(PlayerMessage message, Decoder<A> decoder) {
    try {
      return new Outcome.Done<>(decoder.decode(message));
    } catch (PlayerException e) {
      return new Outcome.Failed<>(problem(e));
    }
  }

  private String problem(PlayerException e) {
    return name() + " at " + link.client().peer() + ": " + e.getMessage();
  }
}
