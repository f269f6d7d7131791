package org.robotui.ros2;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.robotui.message.MessageException;
import org.robotui.message.description.TypeHash;
import org.robotui.message.ros.std_msgs.StdString;
import org.robotui.ros2.internal.graph.Entities;
import org.robotui.ros2.internal.graph.EntitiesCodec;
import org.robotui.ros2.internal.graph.UserData;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.Sample;
import org.robotui.rtps.VendorId;

/** Robots of several distributions, as they speak; of these only Kilted was met for real. */
class DistributionsTest {
  private static final Ros2Codec<StdString> TEXT = Ros2Codec.of(StdString.class);
  private static final String GRAPH = "ros_discovery_info";
  private static final String GRAPH_TYPE = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_";
  private static final ByteBuffer NOTHING = ByteBuffer.allocate(0);

  private final Queue<String> told = new ConcurrentLinkedQueue<>();

  /** A node {@code talker} that says something once it is known, and hears what nodes we have. */
  private void talks(int gidBytes, Optional<TypeHash> hash) throws InterruptedException {
    try (FakeDomain domain = new FakeDomain()) {
      BlockingQueue<String> heard = new LinkedBlockingQueue<>();
      Ros2Node node = domain.context().node("listener");
      Ros2Subscriber subscriber = node.subscriber("chatter", TEXT, Ros2SubscriberOptions.observing(),
          (text, from) -> heard.add(from.from() + " " + text.data() + " " + from.hash().equals(hash)));
      FakeParticipant robot = domain.participant(VendorId.FAST_DDS);
      robot.reader(GRAPH, GRAPH_TYPE, QosProfiles.LATCHED, NOTHING, this::nodes);
      FakeWriter talk = (FakeWriter) robot.writer("rt/chatter", "std_msgs::msg::dds_::String_", QosProfiles.DEFAULT,
          UserData.of(hash));
      robot.writer(GRAPH, GRAPH_TYPE, QosProfiles.LATCHED, NOTHING).write(EntitiesCodec.encode(
          new Entities(robot.info().guid(),
              List.of(new Entities.Node("/", "talker", List.of(), List.of(talk.info().guid())))),
          gidBytes));
      Eventually.await("the node is known", () -> subscriber.publishers().equals(Set.of(Ros2Name.of("/talker"))));
      talk.write(TEXT.encode(new StdString("hello")));
      assertEquals("/talker hello true", heard.poll(30, TimeUnit.SECONDS));
      Eventually.await("it hears of our node as it speaks itself", () -> told.contains("listener " + gidBytes));
    }
  }

  private void nodes(Sample sample) {
    try {
      EntitiesCodec.Decoded said = EntitiesCodec.decode(sample.payload());
      said.entities().nodes().forEach(node -> told.add(node.name() + " " + said.gidBytes()));
    } catch (MessageException e) {
      told.add(e.getMessage());
    }
  }

  @Test
  void humbleAnnouncesNoSumsAndHasLongIdentifiers() throws InterruptedException {
    talks(EntitiesCodec.OLD_GID_BYTES, Optional.empty());
  }

  @Test
  void ironAndLaterAnnounceSumsAndHaveShortIdentifiers() throws InterruptedException {
    talks(EntitiesCodec.GID_BYTES, TEXT.hash());
  }

  @Test
  void programsThatAnnounceNoSumsAreHeardAlsoWhereOthersDo() throws InterruptedException {
    talks(EntitiesCodec.GID_BYTES, Optional.empty());
  }
}
