package org.robotui.ros.internal.master;

import java.io.IOException;
import java.net.URI;
import java.util.Optional;
import java.util.concurrent.ThreadFactory;
import org.robotui.message.MessageInfo;
import org.robotui.message.RawCodec;
import org.robotui.message.RawMessage;
import org.robotui.ros.GraphName;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.Publisher;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosEnvironment;
import org.robotui.ros.RosNode;
import org.robotui.ros.SubscriberOptions;

/** The node that gathers the log messages of all nodes on one topic, as it comes with every roscore. */
final class Rosout {

  private static final String LOG_DEFINITION = """
      byte DEBUG=1
      byte INFO=2
      byte WARN=4
      byte ERROR=8
      byte FATAL=16
      Header header
      byte level
      string name
      string msg
      string file
      string function
      uint32 line
      string[] topics

      ================================================================================
      MSG: std_msgs/Header
      uint32 seq
      time stamp
      string frame_id
      """;

  private Rosout() {}

  /** Opens the node; closing it ends the gathering. */
  static RosNode open(URI master, Optional<String> host, ThreadFactory threads) throws IOException {
    RosEnvironment plain = RosEnvironment.of(master);
    RosEnvironment environment = host.map(plain::withHost).orElse(plain);
    RosNode node = RosNode.open(environment, GraphName.of("/rosout"), NodeOptions.standard(threads));
    RawCodec codec =
        new RawCodec(new MessageInfo("rosgraph_msgs/Log", "acffd30cd6b6de30f120938c17c593fb", LOG_DEFINITION));
    Publisher<RawMessage> gathered = node.publisher("/rosout_agg", codec, PublisherOptions.standard());
    node.subscriber("/rosout", codec, SubscriberOptions.standard(), (message, reception) -> gathered.publish(message));
    return node;
  }
}
