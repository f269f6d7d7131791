package org.robotui.message.description;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.robotui.message.ActionDefinition;
import org.robotui.message.ActionSchema;
import org.robotui.message.Definitions;
import org.robotui.message.Generation;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.MessageSchema;
import org.robotui.message.SchemaLookup;

/** The sums are those that the build tools of ROS 2 computed for the same types. */
class TypeHashTest {

  private static final Definitions NOTHING = new LocalDefinitions(List.of(), List.of(), Generation.ROS2);

  private final TypeRegistry registry = new TypeRegistry(NOTHING);

  private static Map<String, String> vectors() throws Exception {
    Map<String, String> sums = new TreeMap<>();
    try (InputStream in = TypeHashTest.class.getResourceAsStream("type_hashes.txt")) {
      new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().filter(line -> !line.startsWith("#"))
          .map(line -> line.split(" ")).forEach(words -> sums.put(words[0], words[1]));
    }
    return sums;
  }

  private Optional<TypeDescription> describe(TypeName name) {
    return switch (name.kind()) {
      case MSG -> found(registry.message(name, Optional.empty())).map(schema -> TypeDescription.of(name, schema));
      case SRV -> found(registry.service(name, Optional.empty())).map(schema -> TypeDescription.of(name, schema));
      case ACTION -> found(registry.action(name, Optional.empty())).map(schema -> TypeDescription.of(name, schema));
    };
  }

  private static <S> Optional<S> found(SchemaLookup<S> lookup) {
    return lookup instanceof SchemaLookup.Found<S> known ? Optional.of(known.schema()) : Optional.empty();
  }

  @Test
  void everyShippedTypeHasTheSumOfTheRealPackage() throws Exception {
    Map<String, String> expected = vectors();
    Map<String, String> actual = new TreeMap<>();
    for (String each : expected.keySet()) {
      actual.put(each, describe(TypeName.parse(each).orElseThrow()).map(type -> type.hash().text()).orElse("missing"));
    }
    assertEquals(lines(expected), lines(actual));
    assertTrue(expected.size() > 140, "the sums were read");
  }

  private static String lines(Map<String, String> sums) {
    return String.join("\n", sums.entrySet().stream().map(Object::toString).toList());
  }

  @Test
  void aDescriptionMadeIntoATypeAndDescribedAgainIsTheSame() throws Exception {
    for (String each : vectors().keySet()) {
      TypeName name = TypeName.parse(each).orElseThrow();
      if (name.kind() == TypeName.Kind.MSG) {
        TypeDescription first = describe(name).orElseThrow();
        MessageSchema again = first.schema();
        assertEquals(first.hash(), TypeDescription.of(name, again).hash(), each);
      }
    }
  }

  @Test
  void anotherSumIsRefusedWithBoth() {
    TypeName name = TypeName.parse("std_msgs/msg/String").orElseThrow();
    TypeHash other = new TypeHash("RIHS01_" + "ab".repeat(32));
    SchemaLookup<MessageSchema> lookup = registry.message(name, Optional.of(other));
    assertEquals(new SchemaLookup.Missing<>("the robot's std_msgs/msg/String has the sum abababab, the one known here "
        + describe(name).orElseThrow().hash().brief() + ": the definitions differ"), lookup);
  }

  @Test
  void whatANodeDescribesIsLearnedIfItHasTheSumThatWasAnnounced() throws Exception {
    TypeName name = TypeName.parse("strange_msgs/msg/Reading").orElseThrow();
    MessageSchema schema = MessageSchema.parse("strange_msgs/Reading", """
        uint8 KIND_WARM=1
        std_msgs/Header header
        float64[<=3] values
        string<=7 unit "K"
        ================================================================================
        MSG: std_msgs/Header
        builtin_interfaces/Time stamp
        string frame_id
        """, Generation.ROS2);
    TypeDescription description = TypeDescription.of(name, schema);
    TypeHash wrong = new TypeHash("RIHS01_" + "00ff".repeat(16));
    assertFalse(registry.learn(name, wrong, new DescribedType(description, Map.of())) instanceof SchemaLookup.Found);
    registry.learn(name, description.hash(), new DescribedType(description, Map.of()));
    MessageSchema learned = found(registry.message(name, Optional.of(description.hash()))).orElseThrow();
    assertEquals(schema.definition().fields(), learned.definition().fields());
    assertTrue(learned.definition().constants().isEmpty(), "descriptions have no constants");
  }

  @Test
  void textsThatComeWithADescriptionGiveConstants() throws Exception {
    TypeName name = TypeName.parse("strange_msgs/msg/Level").orElseThrow();
    String text = "uint8 LOW=1\nuint8 level\n";
    TypeDescription description =
        TypeDescription.of(name, MessageSchema.parse("strange_msgs/Level", text, Generation.ROS2));
    registry.learn(name, description.hash(), new DescribedType(description, Map.of(name.toString(), text)));
    assertEquals(1, found(registry.message(name, Optional.of(description.hash()))).orElseThrow().definition()
        .constants().size());
  }

  /** The build tools of ROS 2 computed the sums for a package of ours. */
  @Test
  void anActionAndWhatItIsMadeOfHaveTheSumsOfTheRealTools() throws Exception {
    Definitions shipped = Definitions.shipped(Generation.ROS2);
    ActionSchema action = ActionSchema.resolve(
        ActionDefinition.parse("odd_msgs/Count", "int32 to\n---\nint32 reached\n---\nint32 at\n"), shipped);
    TypeName name = TypeName.parse("odd_msgs/action/Count").orElseThrow();
    assertEquals("RIHS01_ae2df40cfb8783e2285e926f38a21aeeaab7b90716be09b8aa32641ae669d082",
        TypeDescription.of(name, action).hash().text());
    assertEquals("RIHS01_ec42026fd49fc0980bb0ca39209012f1a344e34fba583cba5c672f351332d072",
        TypeDescription.of(name.part("SendGoal"), action.sendGoal()).hash().text());
    assertEquals("RIHS01_ef7d0a56037e93dc44c153f4f942a03d4e5fbb1c7bcaa01122c912e3c8a66232",
        TypeDescription.of(name.part("GetResult"), action.getResult()).hash().text());
    assertEquals("RIHS01_e2116f216ba63a3d6d1ec8505544f153b556c2ccb3c84316e06e1842538d233b",
        TypeDescription.of(name.part("FeedbackMessage"), action.feedbackMessage()).hash().text());
    assertEquals("RIHS01_12736af77702a088443c655672436587d8da339344971d5fe81fcedf062b3197",
        TypeDescription.of(name, action).part("odd_msgs/action/Count_SendGoal_Request").hash().text());
  }
}
