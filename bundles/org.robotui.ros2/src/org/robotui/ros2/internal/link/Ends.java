package org.robotui.ros2.internal.link;

import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.robotui.ros2.internal.graph.GraphKeeper;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.Endpoint;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.MatchListener;
import org.robotui.rtps.Participant;

/** Where the ends of one node are made, and what consists of them. Safe for several threads. */
public final class Ends {

  private final Participant participant;
  private final GraphKeeper graph;
  private final Ros2Name node;
  private final Set<AutoCloseable> links = ConcurrentHashMap.newKeySet();

  /**
   * None yet.
   *
   * @param participant makes them
   * @param graph knows whose they are
   * @param node whose they are
   */
  public Ends(Participant participant, GraphKeeper graph, Ros2Name node) {
    this.participant = participant;
    this.graph = graph;
    this.node = node;
  }

  Participant participant() {
    return participant;
  }

  GraphKeeper graph() {
    return graph;
  }

  /**
   * Remembers what is to be closed with the node.
   *
   * @param link consists of ends
   * @param <L> its type
   * @return the same
   */
  public <L extends AutoCloseable> L opened(L link) {
    links.add(link);
    return link;
  }

  /** Closes all that was opened. */
  public void closeAll() {
    for (AutoCloseable each : links) {
      try {
        each.close();
      } catch (Exception e) {
        throw new IllegalStateException("what belongs to node " + node + " cannot be closed", e);
      }
    }
  }

  <E extends Endpoint> E own(E end) {
    graph.add(node, end);
    return end;
  }

  /** An end that may announce itself anew when what it is matched with changes. */
  <E extends Endpoint> E adapting(E end) {
    end.addListener(new MatchListener() {
      @Override
      public void matched(EndpointInfo remote) {
        graph.changed();
      }
    });
    return own(end);
  }

  void close(AutoCloseable link, Endpoint... parts) {
    links.remove(link);
    for (Endpoint end : parts) {
      graph.remove(node, end);
      end.close();
    }
  }

  Set<Ros2Name> nodes(Endpoint end) {
    return end.matched().stream().flatMap(remote -> graph.node(remote.guid()).stream())
        .collect(Collectors.toUnmodifiableSet());
  }

  List<String> mismatches(Endpoint end) {
    return end.mismatches().stream().flatMap(mismatch -> {
      String who = graph.node(mismatch.remote().guid()).map(Ros2Name::text)
          .orElseGet(() -> mismatch.remote().guid().toString());
      return Stream.of(who + ": " + String.join("; ", mismatch.reasons()));
    }).toList();
  }
}
