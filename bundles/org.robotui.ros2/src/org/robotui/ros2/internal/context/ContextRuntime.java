package org.robotui.ros2.internal.context;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.robotui.message.description.TypeRegistry;
import org.robotui.net.thread.Workers;
import org.robotui.ros2.Ros2Context;
import org.robotui.ros2.Ros2Environment;
import org.robotui.ros2.Ros2Node;
import org.robotui.ros2.Ros2Options;
import org.robotui.ros2.Ros2Types;
import org.robotui.ros2.graph.Ros2Graph;
import org.robotui.ros2.internal.graph.GraphKeeper;
import org.robotui.ros2.internal.link.Ends;
import org.robotui.ros2.internal.type.TypeFinder;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.ros2.name.Ros2NameResolver;
import org.robotui.rtps.Participant;

/** Nodes, by a participant that is theirs alone or shared with other contexts. */
public final class ContextRuntime implements Ros2Context {

  private static final long LAST_NANOS = TimeUnit.SECONDS.toNanos(1);

  private final Participation participation;
  private final Runnable leaving;
  private final Ros2Environment environment;
  private final Workers workers;
  private final TypeFinder types;
  private final Map<Ros2Name, Ros2NodeRuntime> nodes = new ConcurrentHashMap<>();
  private final AtomicBoolean closed = new AtomicBoolean();

  /** Begins to take part by what others may take part by as well; what is said at the end closes it or does not. */
  ContextRuntime(Participation participation, Runnable leaving, Ros2Environment environment, Ros2Options options) {
    this.participation = participation;
    this.leaving = leaving;
    this.environment = environment;
    workers = new Workers(options.threads());
    types = new TypeFinder(participation.participant(), participation.graph(), new TypeRegistry(options.definitions()));
  }

  private static ContextRuntime alone(Participation participation, Ros2Environment environment, Ros2Options options) {
    return new ContextRuntime(participation, participation::close, environment, options);
  }

  /**
   * Begins to take part.
   *
   * @param participant takes part; closed with the context
   * @param environment the surroundings
   * @param options what the owner gives it
   * @return the open context
   */
  public static ContextRuntime on(Participant participant, Ros2Environment environment, Ros2Options options) {
    return alone(Participation.by(participant), environment, options);
  }

  /**
   * Opens a participant.
   *
   * @param environment the surroundings
   * @param options what the owner gives it
   * @return the open context
   * @throws IOException if a socket cannot be opened
   */
  public static ContextRuntime open(Ros2Environment environment, Ros2Options options) throws IOException {
    return alone(Participation.open(environment, options, options.threads()), environment, options);
  }

  @Override
  public Ros2Node node(String name) {
    Ros2NameResolver names = Ros2NameResolver.of(environment.namespace(), name, environment.rules());
    if (closed.get()) {
      throw new IllegalStateException("the context of node " + names.node() + " is closed");
    }
    GraphKeeper graph = participation.graph();
    if (!graph.addNode(names.node())) {
      throw new IllegalStateException("this participant has a node " + names.node() + " already");
    }
    Ends ends = new Ends(participation.participant(), graph, names.node());
    Ros2NodeRuntime node = new Ros2NodeRuntime(this, names, ends, workers);
    nodes.put(names.node(), node);
    return node;
  }

  void left(Ros2NodeRuntime node) {
    nodes.remove(node.name(), node);
    participation.graph().removeNode(node.name());
  }

  @Override
  public Ros2Graph graph() {
    return participation.graph();
  }

  @Override
  public Ros2Types types() {
    return types;
  }

  @Override
  public Participant participant() {
    return participation.participant();
  }

  @Override
  public void close() {
    if (closed.compareAndSet(false, true)) {
      try {
        types.close();
        List.copyOf(nodes.values()).forEach(Ros2NodeRuntime::close);
      } finally {
        leaving.run();
      }
    }
    workers.join(System.nanoTime() + LAST_NANOS);
  }
}
