package org.robotui.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MessageRegistryTest {

  private static final String NO_MD5 = MessageInfo.ANY;

  @TempDir
  private Path folder;

  private MessageRegistry registry() {
    return new MessageRegistry(new LocalDefinitions(List.of(folder.resolve("share")), List.of(folder)));
  }

  private void write(String file, String text) throws Exception {
    Path path = folder.resolve(file);
    Files.createDirectories(path.getParent());
    Files.writeString(path, text);
  }

  @Test
  void shippedTypesAreFound() {
    assertEquals("6a62c6daae103f4ff57a132d6f95cec2", found(registry().message("sensor_msgs/Imu")).info().md5());
    assertInstanceOf(SchemaLookup.Found.class, registry().service("std_srvs/SetBool"));
  }

  @Test
  void localTypesAreFoundInShareFoldersAndInWorkspaces() throws Exception {
    write("share/one/msg/A.msg", "two/B b");
    write("src/stack/two/msg/B.msg", "Header header");
    write("src/stack/two/srv/S.srv", "B b\n---\n");
    MessageSchema a = found(registry().message("one/A"));
    assertTrue(a.nested().keySet().containsAll(List.of("two/B", "std_msgs/Header")));
    assertInstanceOf(SchemaLookup.Found.class, registry().service("two/S"));
    assertInstanceOf(SchemaLookup.Found.class, registry().message("two/SRequest"));
  }

  @Test
  void packagesInsidePackagesAndIgnoredFoldersAreNotSearched() throws Exception {
    write("ws/outer/package.xml", "");
    write("ws/outer/test/inner/msg/A.msg", "int8 x");
    write("ws/old/CATKIN_IGNORE", "");
    write("ws/old/gone/msg/A.msg", "int8 x");
    write("ws/new/here/msg/A.msg", "int8 x");
    LocalDefinitions local = new LocalDefinitions(List.of(), List.of(folder.resolve("ws")));
    assertTrue(local.find("inner/A").isEmpty());
    assertTrue(local.find("gone/A").isEmpty());
    assertTrue(local.find("here/A").isPresent());
  }

  @Test
  void anUnknownOrBrokenTypeHasAReason() throws Exception {
    write("share/bad/msg/A.msg", "float64");
    assertTrue(reason(registry().message("bad/A")).contains("bad/A, line 1"));
    assertTrue(reason(registry().message("no/Such")).contains("no definition of the message type no/Such"));
    assertTrue(reason(registry().service("no/Such")).contains("no definition of the service type no/Such"));
    assertTrue(reason(registry().message("../etc/passwd")).contains("no definition"));
    assertTrue(reason(registry().service("std_srvs/SetBool", "0".repeat(32))).contains("the definitions differ"));
  }

  private static <S> S found(SchemaLookup<S> lookup) {
    return switch (lookup) {
      case SchemaLookup.Found<S> found -> found.schema();
      case SchemaLookup.Missing<S> missing -> throw new AssertionError(missing.reason());
    };
  }

  private static String reason(SchemaLookup<?> lookup) {
    return assertInstanceOf(SchemaLookup.Missing.class, lookup).reason();
  }

  @Test
  void aTypeIsLearnedFromAPeerAndThenKnownByName() throws Exception {
    MessageRegistry registry = registry();
    String text = "Inner[] inners\n" + "=".repeat(80) + "\nMSG: robot/Inner\nfloat32 v";
    String md5 = MessageSchema.parse("robot/Outer", text).info().md5();
    DynamicMessage m = new AnyCodec(registry).decode(
        ByteBuffer.wrap(new byte[]{1, 0, 0, 0, 0, 0, (byte) 0x80, 0x3f}),
        new MessageInfo("robot/Outer", md5, text));
    assertEquals(1, m.number("inners[0].v").orElseThrow());
    assertInstanceOf(SchemaLookup.Found.class, registry.message("robot/Outer"));
    assertInstanceOf(SchemaLookup.Found.class, registry.message("robot/Inner"));
  }

  @Test
  void aPeerWhoseDefinitionDoesNotHaveTheAnnouncedSumIsRefused() {
    MessageInfo lie = new MessageInfo("p/T", "0".repeat(32), "int8 x");
    assertTrue(reason(registry().learn(lie)).contains("but the peer announced"));
    MessageException e = assertThrows(MessageException.class,
        () -> new AnyCodec(registry()).decode(ByteBuffer.allocate(1), lie));
    assertTrue(e.problem().contains("in the connection header"));
  }

  @Test
  void aPeerWithoutADefinitionIsDecodedByTheKnownOne() {
    assertInstanceOf(SchemaLookup.Found.class,
        registry().learn(new MessageInfo("std_msgs/String", "992ce8a1687cec8c8bd883ec73ca41d1", "")));
    assertInstanceOf(SchemaLookup.Missing.class,
        registry().learn(new MessageInfo("std_msgs/String", "0".repeat(32), "")));
    assertInstanceOf(SchemaLookup.Found.class,
        registry().learn(new MessageInfo("any/Empty", "d41d8cd98f00b204e9800998ecf8427e", "")));
    assertInstanceOf(SchemaLookup.Missing.class, registry().learn(new MessageInfo("a/B", NO_MD5, "")));
  }

  @Test
  void theEnvironmentNamesTheFolders() throws Exception {
    write("ws/pkg/msg/A.msg", "int8 x");
    write("install/share/other/msg/B.msg", "int8 x");
    LocalDefinitions local = LocalDefinitions.fromEnvironment(Map.of("ROS_PACKAGE_PATH",
        folder.resolve("ws") + ":" + folder.resolve("missing"),
        "CMAKE_PREFIX_PATH", folder.resolve("install").toString()));
    assertTrue(local.find("pkg/A").isPresent());
    assertTrue(local.find("other/B").isPresent());
    assertTrue(local.find("other/C").isEmpty());
  }
}
