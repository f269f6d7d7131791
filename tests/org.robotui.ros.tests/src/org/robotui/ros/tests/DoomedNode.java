package org.robotui.ros.tests;

import java.net.URI;
import java.nio.file.Path;
import java.time.Duration;
import org.robotui.message.RecordCodec;
import org.robotui.message.ros.std_msgs.StdString;
import org.robotui.message.ros.std_srvs.SetBoolResponse;
import org.robotui.ros.GraphName;
import org.robotui.ros.NodeOptions;
import org.robotui.ros.PublisherOptions;
import org.robotui.ros.RosEnvironment;
import org.robotui.ros.RosNode;
import org.robotui.ros.SubscriberOptions;
import org.robotui.ros.msgs.StandardServices;

/** A process with one of our nodes, to be killed by a test: MASTER FOLDER. */
final class DoomedNode {

  private DoomedNode() {}

  public static void main(String[] arguments) throws Exception {
    NodeOptions options = NodeOptions.standard(Thread.ofPlatform().factory()).withRecords(Path.of(arguments[1]));
    RosNode node = RosNode.open(RosEnvironment.of(URI.create(arguments[0])), GraphName.of("doomed"), options);
    node.publisher("/chatter", RecordCodec.of(StdString.class), PublisherOptions.standard());
    node.subscriber("/chatter", RecordCodec.of(StdString.class), SubscriberOptions.standard(), (text, reception) -> {});
    node.serviceServer("~switch", StandardServices.SET_BOOL, (request, caller) -> new SetBoolResponse(true, ""));
    if (!node.awaitRegistered(Duration.ofSeconds(20))) {
      throw new IllegalStateException("not registered");
    }
    System.out.println("ready");
    node.whenClosed().toCompletableFuture().join();
  }
}
