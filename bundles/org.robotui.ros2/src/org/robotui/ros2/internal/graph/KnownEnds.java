package org.robotui.ros2.internal.graph;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import org.robotui.message.description.TypeHash;
import org.robotui.message.description.TypeName;
import org.robotui.ros2.graph.GraphEnd;
import org.robotui.ros2.name.DdsName;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.Durability;
import org.robotui.rtps.EndpointInfo;
import org.robotui.rtps.Guid;

/** The ends that others announced, with the nodes that they belong to. Safe for several threads. */
final class KnownEnds {

  /**
   * One end.
   *
   * @param info as it was announced
   * @param dds what its topic is in ROS 2
   * @param type its type, if it is one of ROS 2
   * @param hash the sum of its type
   */
  record End(EndpointInfo info, DdsName dds, Optional<TypeName> type, Optional<TypeHash> hash) {

    static Optional<End> of(EndpointInfo info) {
      return DdsName.parse(info.topic())
          .map(dds -> new End(info, dds, DdsName.type(info.type()), UserData.hash(info.userData())));
    }

    GraphEnd at(Optional<Ros2Name> node, boolean own) {
      String text = type.map(TypeName::toString).orElse(info.type());
      return new GraphEnd(info.guid(), node, type, text, hash, info.qos(), own);
    }

    boolean kept() {
      return info.qos().durability() != Durability.VOLATILE;
    }
  }

  private final Map<Guid, End> ends = new ConcurrentHashMap<>();
  private final Map<Guid, Ros2Name> nodes = new ConcurrentHashMap<>();
  private final Map<Guid, Entities> entities = new ConcurrentHashMap<>();

  void put(EndpointInfo info) {
    End.of(info).ifPresent(end -> ends.put(info.guid(), end));
  }

  void remove(EndpointInfo info) {
    ends.remove(info.guid());
  }

  /** Takes what a participant says of its nodes; it speaks for its own ends alone. */
  void say(Entities said) {
    forget(said.participant());
    entities.put(said.participant(), said);
    for (Entities.Node node : said.nodes()) {
      name(node).ifPresent(name -> Stream.concat(node.readers().stream(), node.writers().stream())
          .filter(guid -> guid.prefix().equals(said.participant().prefix())).forEach(guid -> nodes.put(guid, name)));
    }
  }

  static Optional<Ros2Name> name(Entities.Node node) {
    return Ros2Name.parse((node.namespace().equals("/") ? "" : node.namespace()) + "/" + node.name());
  }

  void forget(Guid participant) {
    entities.remove(participant);
    nodes.keySet().removeIf(guid -> guid.prefix().equals(participant.prefix()));
  }

  Optional<End> end(Guid guid) {
    return Optional.ofNullable(ends.get(guid));
  }

  Optional<Ros2Name> node(Guid guid) {
    return Optional.ofNullable(nodes.get(guid));
  }

  Collection<End> all() {
    return List.copyOf(ends.values());
  }

  Collection<Entities> said() {
    return List.copyOf(entities.values());
  }
}
