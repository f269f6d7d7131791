package org.robotui.rfic.rosbridge.internal.session;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import org.robotui.message.DefinitionException;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.net.call.Outcome;
import org.robotui.rosbridge.RosApi;

/**
 * Asks rosapi again and again what there is, and once for each definition that is needed, on a thread of its own, as
 * answers may be long in coming.
 */
public final class RosApiWatch implements AutoCloseable {
  private static final Duration PERIOD = Duration.ofMillis(500);
  /** For so long after a question of a user somebody looks. */
  private static final Duration ATTENTION = Duration.ofSeconds(10);

  private final RosApi api;
  private final BridgeDefinitions definitions;
  private final Thread thread;
  private final BlockingQueue<String> wanted = new LinkedBlockingQueue<>();
  private final Map<String, SchemaLookup<MessageSchema>> schemas = new ConcurrentHashMap<>();
  private final NodeSurvey survey = new NodeSurvey();
  private volatile RosGraph graph = RosGraph.EMPTY;
  private volatile long browsedNanos = System.nanoTime() - ATTENTION.toNanos();
  private volatile Optional<String> problem = Optional.empty();
  private volatile boolean answered;

  RosApiWatch(RosApi api, BridgeDefinitions definitions, ThreadFactory threads) {
    this.api = api;
    this.definitions = definitions;
    this.thread = threads.newThread(this::run);
    thread.start();
  }

  private void run() {
    try {
      while (true) {
        look();
        learn(System.nanoTime() + PERIOD.toNanos());
      }
    } catch (InterruptedException e) {
      // closed
    }
  }

  private void look() throws InterruptedException {
    Outcome<Map<String, String>> topics = api.topics();
    Outcome<List<String>> names = api.nodes();
    if (topics.toOptional().isEmpty() || names.toOptional().isEmpty()) {
      problem = Optional.of(topics.toOptional().isEmpty() ? topics.reason() : names.reason());
      return;
    }
    survey.begin(topics.toOptional().get().keySet(), names.toOptional().get(),
        System.nanoTime() - browsedNanos < ATTENTION.toNanos());
    ask(System.nanoTime() + PERIOD.toNanos());
    graph = new RosGraph(topics.toOptional().get(), survey.nodes());
    problem = Optional.empty();
    answered = true;
  }

  /** Asks about some nodes, no longer than until a time where answers are slow. */
  private void ask(long until) throws InterruptedException {
    for (Optional<String> next = survey.next(); next.isPresent(); next = survey.next()) {
      survey.answered(next.get(), api.node(next.get()).toOptional());
      if (System.nanoTime() - until > 0) {
        return;
      }
    }
  }

  /** Asks for definitions as they are wanted, until it is time to look again. */
  private void learn(long until) throws InterruptedException {
    for (long left = PERIOD.toNanos(); left > 0; left = until - System.nanoTime()) {
      String type = wanted.poll(left, TimeUnit.NANOSECONDS);
      if (type != null && !schemas.containsKey(type)) {
        schemas.put(type, learned(type));
      }
    }
  }

  private SchemaLookup<MessageSchema> learned(String type) throws InterruptedException {
    String written = graph.written(type);
    Outcome<String> text = definitions.message(written);
    if (!(text instanceof Outcome.Done<String> done)) {
      return new SchemaLookup.Missing<>(text.reason());
    }
    try {
      return new SchemaLookup.Found<>(MessageSchema.parse(written, done.value(), graph.generation()));
    } catch (DefinitionException e) {
      return new SchemaLookup.Missing<>(e.getMessage());
    }
  }

  /**
   * The definition of a type.
   *
   * @param type a name of two parts
   * @return none until it was asked for, which this begins
   */
  Optional<SchemaLookup<MessageSchema>> schema(String type) {
    Optional<SchemaLookup<MessageSchema>> known = Optional.ofNullable(schemas.get(type));
    if (known.isEmpty() && !wanted.contains(type)) {
      wanted.add(type);
    }
    return known;
  }

  /**
   * What there was when rosapi answered last.
   *
   * @return the graph
   */
  public RosGraph graph() {
    return graph;
  }

  /**
   * The same for a user who looks at it: for a while after this the bridge is asked more often.
   *
   * @return the graph
   */
  public RosGraph browsed() {
    browsedNanos = System.nanoTime();
    return graph;
  }

  /** Why nothing new is known. */
  Optional<String> problem() {
    return problem;
  }

  /** Whether it has answered at all. */
  boolean answered() {
    return answered;
  }

  @Override
  public void close() {
    thread.interrupt();
  }
}
