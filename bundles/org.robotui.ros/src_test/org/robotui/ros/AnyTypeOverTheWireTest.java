package org.robotui.ros;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;

import org.junit.jupiter.api.Test;
import org.robotui.message.AnyCodec;
import org.robotui.message.DynamicCodec;
import org.robotui.message.DynamicMessage;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.MessageRegistry;
import org.robotui.message.MessageSchema;

class AnyTypeOverTheWireTest {

  private static final String DEFINITION =
      "Header header\nWheel[] wheels\n" + "=".repeat(80) + "\nMSG: robot/Wheel\nstring name\nfloat64 speed\n"
          + "=".repeat(80) + "\nMSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n";

  @Test
  void aTypeNobodyKnowsIsDecodedByTheDefinitionInTheConnectionHeader() throws Exception {
    DynamicCodec codec = new DynamicCodec(MessageSchema.parse("robot/Drive", DEFINITION));
    AnyCodec any = new AnyCodec(new MessageRegistry(new LocalDefinitions(List.of(), List.of())));
    List<DynamicMessage> got = new CopyOnWriteArrayList<>();
    DynamicMessage sent = codec.build(Map.of("wheels", List.of(
        Map.of("name", "left", "speed", 1.5), Map.of("name", "right", "speed", -2))));
    try (Graph graph = new Graph();
        Publisher<DynamicMessage> publisher =
            graph.node("robot").publisher("drive", codec, PublisherOptions.latched());
        Subscriber subscriber = graph.node("viewer")
            .subscriber("drive", any, SubscriberOptions.standard(), (m, reception) -> got.add(m))) {
      publisher.publish(sent);
      Eventually.await("the message", () -> got.size() == 1 && subscriber.received() == 1);
    }
    assertEquals(sent, got.getFirst());
    assertEquals(-2, got.getFirst().number("wheels[1].speed").orElseThrow());
  }
}
