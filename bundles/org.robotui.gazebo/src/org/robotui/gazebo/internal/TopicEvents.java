package org.robotui.gazebo.internal;

import org.robotui.gazebo.GazeboListener;
import org.robotui.gazebo.internal.DiscoveryMessage.Announcement;
import org.robotui.gazebo.internal.DiscoveryMessage.Ends;
import org.robotui.gazebo.internal.DiscoveryMessage.Kind;

/** What discovery finds, of topics and of services: who offers what, and what is to be connected to. */
final class TopicEvents implements DiscoveryEvents {
  private final GraphState graph;
  private final Reception reception;
  private final SocketLoop loop;
  private final NodeSockets sockets;
  private final GazeboListener listener;

  TopicEvents(GraphState graph, Reception reception, SocketLoop loop, NodeSockets sockets, GazeboListener listener) {
    this.graph = graph;
    this.reception = reception;
    this.loop = loop;
    this.sockets = sockets;
    this.listener = listener;
  }

  @Override
  public void found(Announcement announced) {
    changed(graph.found(announced));
    reception.found(announced);
  }

  @Override
  public void lost(Announcement announced) {
    reception.lost(announced);
    if (announced.ends() instanceof Ends.Requests) {
      loop.leave(() -> sockets.askNoMore(announced.address()));
    }
    changed(graph.lost(announced));
  }

  @Override
  public void connected(Announcement subscription) {
    changed(graph.connected(subscription));
  }

  @Override
  public void disconnected(Announcement subscription) {
    changed(graph.disconnected(subscription));
  }

  @Override
  public void processes() {
    listener.onGraph();
  }

  @Override
  public void subscribersWanted() {
    reception.subscriptions()
        .forEach(each -> reception.tellBy().ifPresent(by -> by.tell(Kind.SUBSCRIBERS_REPLY, each)));
  }

  @Override
  public void unreadable(String reason) {
    listener.onUnreadable(reason);
  }

  private void changed(boolean changed) {
    if (changed) {
      listener.onGraph();
    }
  }
}
