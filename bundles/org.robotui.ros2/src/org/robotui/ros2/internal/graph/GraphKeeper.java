package org.robotui.ros2.internal.graph;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicLong;
import org.robotui.message.MessageException;
import org.robotui.message.description.TypeHash;
import org.robotui.net.log.LogThrottle;
import org.robotui.net.thread.Uninterruptibles;
import org.robotui.ros2.QosProfiles;
import org.robotui.ros2.graph.GraphNode;
import org.robotui.ros2.graph.GraphState;
import org.robotui.ros2.graph.Ros2Graph;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.DiscoveryListener;
import org.robotui.rtps.Endpoint;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.Guid;
import org.robotui.rtps.Participant;
import org.robotui.rtps.ParticipantInfo;
import org.robotui.rtps.Reader;
import org.robotui.rtps.Sample;
import org.robotui.rtps.VendorId;
import org.robotui.rtps.Writer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Keeps what others announce, and announces the nodes of this context. */
public final class GraphKeeper implements Ros2Graph, DiscoveryListener, AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(GraphKeeper.class);
  private static final String TOPIC = "ros_discovery_info";
  private static final String TYPE = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_";

  /** Whoever has been killed or stopped does not hold up the end for longer. */
  private static final Duration LAST_WORD = Duration.ofSeconds(2);

  private final Participant participant;
  private final KnownEnds known = new KnownEnds();
  private final OwnEnds own = new OwnEnds();
  private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
  private final LogThrottle faults = new LogThrottle();
  private final AtomicLong version = new AtomicLong();
  private final Writer writer;
  private final Reader reader;
  private Entities told = new Entities(Guid.UNKNOWN, List.of());
  private int gidBytes = EntitiesCodec.GID_BYTES;
  private volatile Dated state = new Dated(-1, new GraphState(List.of(), List.of(), List.of(), List.of()));

  /** A state, and the version of what it was made from. */
  private record Dated(long version, GraphState state) {}

  /**
   * Begins to keep.
   *
   * @param participant whose surroundings
   */
  public GraphKeeper(Participant participant) {
    this.participant = participant;
    ByteBuffer nothing = ByteBuffer.allocate(0);
    writer = participant.writer(TOPIC, TYPE, QosProfiles.LATCHED, nothing);
    reader = participant.reader(TOPIC, TYPE, QosProfiles.LATCHED, nothing, this::received);
    participant.discovery().addListener(this);
  }

  private void received(Sample sample) {
    boolean ours = sample.writer().prefix().equals(participant.info().guid().prefix());
    if (ours || sample.kind() != Sample.Kind.ALIVE) {
      return;
    }
    try {
      EntitiesCodec.Decoded said = EntitiesCodec.decode(sample.payload());
      if (!said.entities().participant().prefix().equals(sample.writer().prefix())) {
        throw new MessageException("it speaks for another participant, " + said.entities().participant(), "gid", 0);
      }
      known.say(said.entities());
      speakAs(said.gidBytes());
      changed();
    } catch (MessageException e) {
      if (faults.admit()) {
        LOG.warn("{} says nothing of use about its nodes: {} ({} such messages)", sample.writer(), e.getMessage(),
            faults.count());
      }
    }
  }

  /** Peers of one generation do not understand the other; those of a domain are of one. */
  private void speakAs(int bytes) {
    synchronized (own) {
      if (bytes != gidBytes) {
        gidBytes = bytes;
        told = new Entities(Guid.UNKNOWN, List.of());
      }
    }
  }

  @Override
  public void endpointFound(EndpointInfo endpoint) {
    known.put(endpoint);
    changed();
  }

  @Override
  public void endpointChanged(EndpointInfo endpoint) {
    endpointFound(endpoint);
  }

  @Override
  public void endpointLost(EndpointInfo endpoint, String reason) {
    known.remove(endpoint);
    changed();
  }

  @Override
  public void participantLost(ParticipantInfo lost, String reason) {
    known.forget(lost.guid());
    changed();
  }

  /**
   * Adds a node.
   *
   * @param name its name
   * @return false if there is one of that name
   */
  public boolean addNode(Ros2Name name) {
    boolean added = own.addNode(name);
    changed();
    return added;
  }

  /**
   * Removes a node.
   *
   * @param name its name
   */
  public void removeNode(Ros2Name name) {
    own.removeNode(name);
    changed();
  }

  /**
   * Adds an end of a node.
   *
   * @param node which one
   * @param end what it has
   */
  public void add(Ros2Name node, Endpoint end) {
    own.add(node, end);
    changed();
  }

  /**
   * Removes an end of a node.
   *
   * @param node which one
   * @param end what it had
   */
  public void remove(Ros2Name node, Endpoint end) {
    own.remove(node, end);
    changed();
  }

  /** Says what has changed, to others and to those who listen here. */
  public void changed() {
    version.incrementAndGet();
    synchronized (own) {
      Entities now = own.entities(participant.info().guid());
      if (!now.equals(told)) {
        told = now;
        writer.write(EntitiesCodec.encode(now, gidBytes));
      }
    }
    for (Runnable each : listeners) {
      try {
        each.run();
      } catch (RuntimeException e) {
        LOG.error("a listener of the graph failed", e);
      }
    }
  }

  /**
   * The node of a remote end.
   *
   * @param end which one
   * @return empty while its process has not said it
   */
  public Optional<Ros2Name> node(Guid end) {
    return known.node(end);
  }

  /**
   * The sum of the type that a remote end announced.
   *
   * @param end which one
   * @return empty where it announced none
   */
  public Optional<TypeHash> hash(Guid end) {
    return known.end(end).flatMap(KnownEnds.End::hash);
  }

  /**
   * Whether a remote writer keeps messages for late readers.
   *
   * @param end which one
   * @return false where it is not known
   */
  public boolean kept(Guid end) {
    return known.end(end).filter(KnownEnds.End::kept).isPresent();
  }

  /**
   * Whose DDS a remote end has.
   *
   * @param end which one
   * @return the vendor of its participant
   */
  public VendorId vendor(Guid end) {
    return participant.discovery().participant(end.prefix()).map(ParticipantInfo::vendor).orElse(VendorId.UNKNOWN);
  }

  @Override
  public GraphState state() {
    long now = version.get();
    Dated last = state;
    if (last.version() != now) {
      last = new Dated(now, build());
      state = last;
    }
    return last.state();
  }

  private GraphState build() {
    StateBuilder builder = new StateBuilder();
    known.all().forEach(end -> builder.add(end, known.node(end.info().guid()), false));
    own.each((node, end) -> KnownEnds.End.of(end.info())
        .ifPresent(each -> builder.add(each, Optional.of(node), true)));
    List<GraphNode> nodes = new ArrayList<>();
    ParticipantInfo self = participant.info();
    own.names().forEach(name -> nodes.add(new GraphNode(name, self.guid(), self.vendor(), true)));
    for (Entities said : known.said()) {
      said.nodes().forEach(node -> KnownEnds.name(node)
          .ifPresent(name -> nodes.add(new GraphNode(name, said.participant(), vendor(said.participant()), false))));
    }
    return builder.state(nodes);
  }

  @Override
  public AutoCloseable onChange(Runnable listener) {
    listeners.add(listener);
    return () -> listeners.remove(listener);
  }

  @Override
  public void close() {
    participant.discovery().removeListener(this);
    awaitHeard();
    reader.close();
    writer.close();
  }

  /**
   * Waits until all have heard that there is no node any more. rmw_fastrtps takes what a participant said before as
   * news where it looks at it after the participant has gone, and keeps its nodes for ever.
   */
  private void awaitHeard() {
    boolean[] heard = {false};
    Uninterruptibles.await(System.nanoTime() + LAST_WORD.toNanos(),
        nanos -> heard[0] = writer.awaitAcknowledged(Duration.ofNanos(Math.max(0, nanos))));
    if (!heard[0]) {
      LOG.debug("somebody has not acknowledged within {} that the nodes are gone", LAST_WORD);
    }
  }
}
