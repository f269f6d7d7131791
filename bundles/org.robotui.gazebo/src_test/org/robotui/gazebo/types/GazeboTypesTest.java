package org.robotui.gazebo.types;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.google.protobuf.Descriptors.Descriptor;
import com.google.protobuf.Descriptors.FieldDescriptor;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class GazeboTypesTest {
  private static final String OWN = """
      /* of a robot */ syntax = "proto3"; package my.robot;
      import "gz/msgs/header.proto";
      option java_package = "x";
      message Grip { // closes
        enum Mood { option allow_alias = true; CALM = 0; EAGER = 1; KEEN = 1; COLD = -2; }
        message Finger { double force = 1 [deprecated = true]; }
        repeated Finger fingers = 1; Mood mood = 2; map<string, double> limits = 3;
        oneof what { option (x) = 1; string name = 4; bool all = 5; }
        reserved 6, 7; optional uint32 count = 0x8; gz.msgs.Header header = 9;
      }
      service S { rpc Do (Grip) returns (Grip) { option x = 1; } }
      enum Size { SMALL = 0; }
      """;

  @TempDir
  Path folder;

  private GazeboTypes types() {
    return GazeboTypes.of(Map.of("GZ_DESCRIPTOR_PATH", folder.toString()));
  }

  @Test
  void typesOfBothPackagesAreKnown() {
    for (String prefix : new String[]{"gz.msgs.", "ignition.msgs."}) {
      Descriptor scan = types().find(prefix + "LaserScan").orElseThrow();
      assertEquals(prefix + "LaserScan", scan.getFullName());
      assertEquals(14, scan.findFieldByName("ranges").getNumber());
      assertEquals(prefix + "Time", types().find(prefix + "Header").orElseThrow().findFieldByName("stamp")
          .getMessageType().getFullName());
    }
    assertTrue(types().find("gz.msgs.NoSuchThing").isEmpty());
    assertTrue(types().find("NoPackage").isEmpty());
  }

  @Test
  void filesOfTheSearchPathAreRead() throws IOException {
    Files.writeString(folder.resolve("grip.proto"), OWN);
    Files.writeString(folder.resolve("broken.proto"), "package my.robot; message Broken { double");
    Descriptor grip = types().find("my.robot.Grip").orElseThrow();
    assertEquals(8, grip.findFieldByName("count").getNumber());
    assertEquals("my.robot.Grip.Finger", grip.findFieldByName("fingers").getMessageType().getFullName());
    assertEquals(FieldDescriptor.JavaType.ENUM, grip.findFieldByName("mood").getJavaType());
    assertEquals(-2, grip.findFieldByName("mood").getEnumType().findValueByName("COLD").getNumber());
    assertTrue(grip.findFieldByName("limits").isMapField());
    assertEquals("what", grip.findFieldByName("all").getContainingOneof().getName());
  }

  @Test
  void whatIsNoDefinitionIsRefused() {
    for (String wrong : new String[]{"message", "message A {", "message A { double x = y; }", "enum A { B; }",
        "message A { oneof b { double", "message A {".repeat(100)}) {
      assertThrows(IllegalArgumentException.class, () -> ProtoReader.read(wrong), wrong);
    }
  }

  @Test
  void spoiledDefinitionsEndInAnErrorOrInTypes() {
    Random random = new Random(1);
    for (int i = 0; i < 2000; i++) {
      StringBuilder text = new StringBuilder(OWN);
      for (int k = random.nextInt(4); k >= 0; k--) {
        int at = random.nextInt(text.length());
        text.setCharAt(at, ";{}[]=\"'/ *a1".charAt(random.nextInt(13)));
      }
      try {
        assertTrue(ProtoReader.read(text.substring(0, random.nextInt(text.length()))).getMessageTypeCount() >= 0);
      } catch (IllegalArgumentException e) {
        assertTrue(!e.getMessage().isBlank());
      }
    }
  }
}
