package org.robotui.ros2.internal.context;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
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
import org.robotui.rtps.ParticipantSettings;

/** A participant with its nodes. */
public final class ContextRuntime implements Ros2Context {

  private static final long LAST_NANOS = TimeUnit.SECONDS.toNanos(1);
  /** A participant says three times within its lease that it is there, and a bit more often. */
  private static final int ANNOUNCEMENTS = 4;

  private final Participant participant;
  private final Ros2Environment environment;
  private final Workers workers;
  private final GraphKeeper graph;
  private final TypeFinder types;
  private final Map<Ros2Name, Ros2NodeRuntime> nodes = new ConcurrentHashMap<>();
  private volatile boolean closed;

  /**
   * Begins to take part.
   *
   * @param participant takes part; closed with this
   * @param environment the surroundings
   * @param options what the owner gives it
   */
  public ContextRuntime(Participant participant, Ros2Environment environment, Ros2Options options) {
    this.participant = participant;
    this.environment = environment;
    workers = new Workers(options.threads());
    graph = new GraphKeeper(participant);
    types = new TypeFinder(participant, graph, new TypeRegistry(options.definitions()));
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
    ParticipantSettings settings = environment.participant(Optional.empty()).withLimits(options.limits());
    if (options.lease().isPresent()) {
      Duration lease = options.lease().get();
      settings = settings.withLease(lease, lease.dividedBy(ANNOUNCEMENTS));
    }
    return new ContextRuntime(Participant.open(settings, options.threads()), environment, options);
  }

  @Override
  public Ros2Node node(String name) {
    Ros2NameResolver names = Ros2NameResolver.of(environment.namespace(), name, environment.rules());
    if (closed) {
      throw new IllegalStateException("the context of node " + names.node() + " is closed");
    }
    if (!graph.addNode(names.node())) {
      throw new IllegalStateException("this context has a node " + names.node() + " already");
    }
    Ros2NodeRuntime node = new Ros2NodeRuntime(this, names, new Ends(participant, graph, names.node()), workers);
    nodes.put(names.node(), node);
    return node;
  }

  void left(Ros2NodeRuntime node) {
    nodes.remove(node.name(), node);
    graph.removeNode(node.name());
  }

  @Override
  public Ros2Graph graph() {
    return graph;
  }

  @Override
  public Ros2Types types() {
    return types;
  }

  @Override
  public Participant participant() {
    return participant;
  }

  @Override
  public void close() {
    closed = true;
    types.close();
    List.copyOf(nodes.values()).forEach(Ros2NodeRuntime::close);
    graph.close();
    participant.close();
    workers.join(System.nanoTime() + LAST_NANOS);
  }
}
