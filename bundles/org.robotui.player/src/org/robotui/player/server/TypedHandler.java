package org.robotui.player.server;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.IntConsumer;
import org.robotui.player.layout.Codec;
import org.robotui.player.layout.Kind;
import org.robotui.player.layout.Layouts;
import org.robotui.player.wire.PlayerException;
import org.robotui.player.wire.PlayerMessage;

/** A device whose commands and requests are Java records. What it does not know, or cannot read, it refuses. */
public final class TypedHandler implements DeviceHandler {

  /** Takes a message. */
  private interface Step {

    Answer take(PlayerMessage message) throws PlayerException;
  }

  private final Layouts layouts;
  private final Map<Integer, Step> commands = new ConcurrentHashMap<>();
  private final Map<Integer, Step> requests = new ConcurrentHashMap<>();
  private final IntConsumer clients;

  /**
   * Creates a handler that knows nothing yet.
   *
   * @param layouts the interfaces that are known
   * @param clients hears how many clients have the device open
   */
  public TypedHandler(Layouts layouts, IntConsumer clients) {
    this.layouts = layouts;
    this.clients = clients;
  }

  /**
   * Adds a command.
   *
   * @param kind the kind
   * @param action takes its body
   * @param <T> the body
   * @return this
   */
  public <T> TypedHandler on(Kind.Command<T> kind, Consumer<T> action) {
    Codec<T> codec = layouts.codec(kind);
    commands.put(layouts.message(kind).subtype(), message -> {
      action.accept(codec.decode(message.payload()));
      return new Answer.Silence();
    });
    return this;
  }

  /**
   * Adds a request.
   *
   * @param kind the kind
   * @param action answers the question; empty to refuse
   * @param <Q> the question
   * @param <A> the answer
   * @return this
   */
  public <Q, A> TypedHandler on(Kind.Request<Q, A> kind, Function<Q, Optional<A>> action) {
    Codec<Q> questions = layouts.question(kind);
    Codec<A> answers = layouts.answer(kind);
    requests.put(layouts.message(kind).subtype(), message -> action.apply(questions.decode(message.payload()))
        .<Answer>map(answer -> new Answer.Ack(answers.encode(answer))).orElseGet(Answer::refused));
    return this;
  }

  @Override
  public void onCommand(PlayerMessage command) {
    take(commands, command);
  }

  @Override
  public Answer onRequest(PlayerMessage request) {
    return take(requests, request);
  }

  private static Answer take(Map<Integer, Step> steps, PlayerMessage message) {
    Step known = steps.getOrDefault(message.subtype(), none -> Answer.refused());
    try {
      return known.take(message);
    } catch (PlayerException e) {
      return Answer.refused();
    }
  }

  @Override
  public void onClients(int count) {
    clients.accept(count);
  }
}
