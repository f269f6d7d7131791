package org.robotui.ros.internal.node;

import java.util.ArrayList;
import java.util.List;
import org.robotui.ros.GraphName;
import org.robotui.ros.XmlRpcValue;
import org.robotui.ros.XmlRpcValue.Array;

/** What a node tells of its links. */
record Bus(NodeParts parts) {

  /** The links; ROS tools read id, peer, direction, transport, topic and whether it is connected. */
  XmlRpcValue info() {
    List<XmlRpcValue> all = new ArrayList<>();
    parts.publications()
        .forEach(p -> p.links().forEach(link -> all.add(link(all.size(), link.subscriber(), "o", p.topic(), true))));
    parts.topics().values().forEach(t -> t.links()
        .forEach(link -> all.add(link(all.size(), link.publisherUri(), "i", t.topic(), link.isConnected()))));
    return new Array(all);
  }

  private static XmlRpcValue link(int id, String peer, String direction, GraphName topic, boolean connected) {
    return XmlRpcValue.of(XmlRpcValue.of(id), XmlRpcValue.of(peer), XmlRpcValue.of(direction), XmlRpcValue.of("TCPROS"),
        XmlRpcValue.of(topic.text()), XmlRpcValue.of(connected), XmlRpcValue.of("TCPROS connection with " + peer));
  }

  /**
   * What went over the links, with the ids of {@link #info}; calls of services are not counted, which leaves their list
   * empty.
   */
  XmlRpcValue stats() {
    int[] id = {0};
    List<XmlRpcValue> published = new ArrayList<>();
    parts.publications().forEach(p -> published.add(published(p, id)));
    List<XmlRpcValue> subscribed = new ArrayList<>();
    parts.topics().values().forEach(t -> subscribed.add(subscribed(t, id)));
    return XmlRpcValue.of(new Array(published), new Array(subscribed), new Array(List.of()));
  }

  private static XmlRpcValue published(Publication<?> publication, int[] id) {
    List<XmlRpcValue> links = new ArrayList<>();
    for (OutLink link : publication.links()) {
      links.add(XmlRpcValue.of(XmlRpcValue.of(id[0]++), count(link.sent().bytes()), count(link.sent().messages()),
          XmlRpcValue.of(true)));
    }
    return XmlRpcValue.of(XmlRpcValue.of(publication.topic().text()), count(publication.sentBytes()), new Array(links));
  }

  private static XmlRpcValue subscribed(SubscribedTopic topic, int[] id) {
    List<XmlRpcValue> links = new ArrayList<>();
    for (InLink link : topic.links()) {
      links.add(XmlRpcValue.of(XmlRpcValue.of(id[0]++), count(link.got().bytes()), count(link.got().messages()),
          XmlRpcValue.of(-1),
          XmlRpcValue.of(link.isConnected())));
    }
    return XmlRpcValue.of(XmlRpcValue.of(topic.topic().text()), new Array(links));
  }

  /** Integers have 32 bits here: a larger count stays at the largest. */
  private static XmlRpcValue count(long value) {
    return XmlRpcValue.of((int) Math.min(Integer.MAX_VALUE, value));
  }
}
