package org.robotui.ros2;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;
import org.robotui.message.description.TypeDescription;
import org.robotui.message.description.TypeHash;
import org.robotui.message.description.TypeName;
import org.robotui.message.ros.rcl_interfaces.RclLog;
import org.robotui.ros2.Ros2Types.TypedMessage;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.VendorId;

/** What a node of ours tells others of itself: its types, and what happens to it. */
class DescriptionsTest {

  private static final Duration LONG = Duration.ofSeconds(30);
  private static final TypeName LEAF = TypeName.parse("demo/msg/Leaf").orElseThrow();

  private final FakeDomain domain = new FakeDomain();

  @TempDir
  Path folder;

  @AfterEach
  void close() {
    domain.close();
  }

  /** A node on a machine where the type of its topic is installed. */
  private Ros2Node tree() throws Exception {
    Path messages = Files.createDirectories(folder.resolve("share/demo/msg"));
    Files.writeString(messages.resolve("Leaf.msg"),
        "string<=9 name \"oak\"\nstd_msgs/Header header\nfloat64[3] place\nuint8[<=4] few\ngeometry_msgs/Pose[] all\n");
    Ros2Options options =
        Ros2Options.standard(Thread::new).withDefinitions(LocalDefinitions.ofRos2(List.of(folder), Map.of()));
    return Ros2Context.on(domain.participant(VendorId.FAST_DDS), Ros2Environment.local(0), options).node("tree");
  }

  @Test
  void othersLearnATypeThatTheyDoNotHave() throws Exception {
    Ros2Node tree = tree();
    SchemaLookup<MessageSchema> installed = tree.context().types().registry().message(LEAF, Optional.empty());
    TypeHash hash =
        TypeDescription.of(LEAF, ((SchemaLookup.Found<MessageSchema>) installed).schema()).hash();
    tree.publisher("leaf", Ros2Codec.raw(LEAF, Optional.of(hash)), QosProfiles.DEFAULT);
    Ros2Descriptions.offer(tree);
    Ros2Types types = domain.context().types();
    SchemaLookup<TypedMessage> learned = types.topic(Ros2Name.of("/leaf"), LONG);
    assertTrue(learned instanceof SchemaLookup.Found, learned.toString());
    MessageSchema schema = ((SchemaLookup.Found<TypedMessage>) learned).schema().schema();
    assertEquals(hash, TypeDescription.of(LEAF, schema).hash());
  }

  @Test
  void whatItDoesNotHaveItSays() throws Exception {
    Ros2Node tree = tree();
    TypeHash hash = TypeHash.parse("RIHS01_" + "7".repeat(64)).orElseThrow();
    tree.publisher("leaf", Ros2Codec.raw(LEAF, Optional.of(hash)), QosProfiles.DEFAULT);
    Ros2Descriptions.offer(tree);
    SchemaLookup<TypedMessage> answer = domain.context().types().topic(Ros2Name.of("/leaf"), LONG);
    assertTrue(answer instanceof SchemaLookup.Missing<TypedMessage> missing
        && missing.reason().contains("/tree does not describe it"), answer.toString());
  }

  @Test
  void whatHappenedIsThereForWhoComesLate() throws Exception {
    Ros2Log log = Ros2Log.open(domain.context().node("arm"));
    log.write(Ros2LogLevel.ERROR, "elbow", "it is stuck", 7);
    BlockingQueue<RclLog> heard = new LinkedBlockingQueue<>();
    domain.context().node("late").subscriber("/rosout", Ros2Codec.of(RclLog.class),
        Ros2SubscriberOptions.of(QosProfiles.LOG), (entry, from) -> heard.add(entry));
    assertEquals(new RclLog(7, RclLog.ERROR, "arm", "it is stuck", "", "elbow", 0), heard.poll(5, TimeUnit.SECONDS));
  }
}
