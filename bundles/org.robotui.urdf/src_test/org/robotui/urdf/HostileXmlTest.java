package org.robotui.urdf;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.urdf.mesh.MeshRead;
import org.robotui.urdf.mesh.MeshReader;

/** What texts try that want more than to describe a robot. */
class HostileXmlTest {
  @Test
  void refusesEntitiesThatGrow() {
    StringBuilder bomb = new StringBuilder("<!DOCTYPE robot [<!ENTITY e0 \"x\">");
    for (int i = 1; i < 30; i++) {
      bomb.append("<!ENTITY e").append(i).append(" \"&e").append(i - 1).append(";&e").append(i - 1).append(";\">");
    }
    assertRefused(bomb + "]><robot name=\"&e29;\"><link name=\"a\"/></robot>", "DOCTYPE");
  }

  @Test
  void readsNoOtherFile(@TempDir Path folder) throws IOException {
    Path secret = Files.writeString(folder.resolve("secret"), "hidden-words");
    String problem = assertRefused("<!DOCTYPE robot [<!ENTITY f SYSTEM \"" + secret.toUri()
        + "\">]><robot name=\"r\"><link name=\"a\">&f;</link></robot>", "DOCTYPE");
    assertFalse(problem.contains("hidden-words"), problem);
    assertRefused("<!DOCTYPE robot SYSTEM \"" + secret.toUri() + "\"><robot name=\"r\"><link name=\"a\"/></robot>",
        "DOCTYPE");
  }

  @Test
  void followsNoInclusion(@TempDir Path folder) throws IOException {
    Path other = Files.writeString(folder.resolve("link.xml"), "<link name=\"included\"/>");
    String text = "<robot name='r' xmlns:xi='http://www.w3.org/2001/XInclude'><link name='a'/><xi:include href='"
        + other.toUri() + "'/></robot>";
    assertTrue(Urdf.parse(text).found().orElseThrow().link("included").isEmpty());
  }

  @Test
  void boundsDepthAndCounts() {
    assertRefused("<a>".repeat(100_000), "deep");
    assertRefused("<robot>" + "<x/>".repeat(600_000) + "</robot>", "more than 500000 elements");
    assertRefused(" ".repeat(16_000_001), "characters");
  }

  @Test
  void doesTheSameInMeshes() {
    byte[] bomb = "<!DOCTYPE COLLADA [<!ENTITY a SYSTEM 'file:///etc/hostname'>]><COLLADA>&a;</COLLADA>"
        .getBytes(StandardCharsets.UTF_8);
    MeshRead.Refused refused =
        assertInstanceOf(MeshRead.Refused.class, MeshReader.read("x.dae", bomb, name -> Optional.empty()));
    assertTrue(refused.why().contains("DOCTYPE"), refused.why());
  }

  private static String assertRefused(String text, String words) {
    Parsed.Refused<?> refused = assertInstanceOf(Parsed.Refused.class, Urdf.parse(text));
    assertTrue(refused.problem().message().contains(words), refused.problem().toString());
    return refused.problem().message();
  }
}
