package org.robotui.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Types that packages of ROS 2 define in IDL. */
class IdlTest {

  private static final String READING = """
      // what a sensor says
      #include "std_msgs/msg/Header.idl"
      module odd_msgs { module msg {
        typedef double double__3[3];
        module Reading_Constants {
          const uint8 WARM = 1;
          const string WORD = "a" "b; }";
          const boolean SURE = TRUE;
          const int8 LESS = -3;
        };
        @verbatim (language="comment", text="one (of) several")
        struct Reading {
          @verbatim (language="comment", text="when { and where")
          std_msgs::msg::Header header;
          double__3 position;
          sequence<float, 5> few;
          sequence<odd_msgs::msg::Part> parts;
          string<7> unit;
          sequence<string<3>> words;
          @default (value=2) @unit (value="K")
          unsigned long long big;
          octet raw, more;
          /* wide */ wstring wide;
        };
      }; };
      """;

  @Test
  void aStructureIsReadAsADefinition() throws DefinitionException {
    assertEquals("""
        uint8 WARM=1
        string WORD="ab; }"
        bool SURE=true
        int8 LESS=-3
        std_msgs/Header header
        float64[3] position
        float32[<=5] few
        odd_msgs/Part[] parts
        string<=7 unit
        string<=3[] words
        uint64 big 2
        byte raw
        byte more
        wstring wide
        """, IdlText.definition("odd_msgs/Reading", "msg", READING));
  }

  @Test
  void servicesAndActionsHaveSeveralStructures(@TempDir Path folder) throws Exception {
    Path action = Files.createDirectories(folder.resolve("odd_msgs/action")).resolve("Count.idl");
    Files.writeString(action, """
        module odd_msgs { module action {
          struct Count_Goal { long to; };
          struct Count_Result { uint8 structure_needs_at_least_one_member; };
          struct Count_Feedback { long at; };
        }; };
        """);
    LocalDefinitions local = new LocalDefinitions(List.of(folder), List.of(), Generation.ROS2);
    ActionDefinition count = local.action("odd_msgs/Count").orElseThrow();
    assertEquals("to", count.goal().fields().get(0).name());
    assertEquals("structure_needs_at_least_one_member", count.result().fields().get(0).name());
    assertTrue(local.service("odd_msgs/Count").isEmpty());
  }

  @Test
  void whatIsNotSupportedIsNamed() {
    for (String each : List.of("module a { interface E {}; };", "module a { struct S { long double d; }; };",
        "module a { struct S { sequence<sequence<long>> s; }; };", "module a { struct S { long m[2][3]; }; };",
        "module a { union U switch (long) {}; };")) {
      DefinitionException e =
          assertThrows(DefinitionException.class, () -> IdlText.definition("a/S", "msg", each), each);
      assertTrue(e.getMessage().contains("is not supported"), e.getMessage());
    }
    assertEquals("definition of a/S: the file in IDL has no structure S",
        assertThrows(DefinitionException.class, () -> IdlText.definition("a/S", "msg", "module a {};")).getMessage());
  }

  @Test
  void brokenTextIsRefusedAndNothingElse() {
    Random random = new Random(3);
    int refused = 0;
    for (int i = 0; i < 3000; i++) {
      StringBuilder text = new StringBuilder(READING);
      for (int change = 0; change < 3; change++) {
        int at = random.nextInt(text.length());
        text.replace(at, Math.min(text.length(), at + random.nextInt(6)),
            "{}();@<>\"/*a1 ".substring(random.nextInt(12)));
      }
      try {
        IdlText.definition("odd_msgs/Reading", "msg", text.toString());
      } catch (DefinitionException e) {
        refused++;
      }
    }
    assertTrue(refused > 500, refused + " were refused");
  }

  @Test
  void filesThatComeInOneTextAreOneType() throws DefinitionException {
    String line = "=".repeat(80) + "\n";
    String part = "module odd_msgs { module msg { struct Part { float size; }; }; };\n";
    String text = line + "IDL: odd_msgs/msg/Pair\nmodule odd_msgs { module msg { struct Pair {\n"
        + "odd_msgs::msg::Part first; builtin_interfaces::msg::Time stamp; }; }; };\n" + line
        + "IDL: odd_msgs/msg/Part\n" + part;
    MessageSchema schema = MessageSchema.parseIdl("odd_msgs/msg/Pair", text);
    assertEquals("odd_msgs/Pair", schema.definition().type());
    assertEquals("float32 size\n", schema.nested().get("odd_msgs/Part").text());
    assertThrows(DefinitionException.class, () -> MessageSchema.parseIdl("odd_msgs/msg/Other", text));
  }
}
