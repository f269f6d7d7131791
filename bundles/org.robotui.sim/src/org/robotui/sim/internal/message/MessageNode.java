package org.robotui.sim.internal.message;

import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.robotui.message.ros.visualization_msgs.InteractiveMarkerInit;

/** A node of either generation of ROS, by what a robot does with both. Names are relative to its namespace. */
public interface MessageNode {
  /** Its whole name, without the slash that it begins with. */
  String name();

  <T extends Record> MessageSink<T> topic(String name, Class<T> type, TopicKind kind);

  /** @param taken called on threads of the node */
  <T extends Record> void listen(String name, Class<T> type, Consumer<T> taken);

  /**
   * Offers a service.
   *
   * @param type such as {@code std_srvs/SetBool}
   * @param answer called on threads of the node; a call that cannot be answered at all is refused by an
   * {@link IllegalStateException}
   */
  <Q extends Record, R extends Record> void service(String name, String type, Class<Q> request, Class<R> response,
      Function<Q, R> answer);

  /**
   * Lets clients have all interactive markers of a server.
   *
   * @param server the namespace of its topics
   * @param now what there is; called on threads of the node
   * @return to be called when that has changed
   */
  Runnable markers(String server, Supplier<InteractiveMarkerInit> now);
}
