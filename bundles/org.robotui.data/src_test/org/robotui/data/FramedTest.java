package org.robotui.data;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.data.geometry.StampedPose;
import org.robotui.data.geometry.TransformSet;
import org.robotui.geometry.RigidTransform;

/** A type that names frames says so: what does not is placed nowhere, without a word. */
class FramedTest {

  @Test
  void everyTypeThatHasAFrameIsFramed() throws Exception {
    List<Class<?>> silent =
        types().filter(FramedTest::namesFrames).filter(type -> !Framed.class.isAssignableFrom(type)).toList();

    assertEquals(List.of(), silent);
  }

  @Test
  void thereAreSuchTypes() throws Exception {
    assertTrue(types().filter(FramedTest::namesFrames).count() > 15);
  }

  @Test
  void aFrameWithoutANameIsLeftOut() {
    assertEquals(List.of(), new StampedPose(new FrameId("robby", ""), RigidTransform.IDENTITY).frames().toList());
    assertFalse(new FrameId("robby", "/").isNamed());
  }

  @Test
  void aSetNamesTheFramesOfAll() {
    FrameId map = new FrameId("robby", "map");
    FrameId base = new FrameId("robby", "base_link");

    assertEquals(List.of(map, base),
        new TransformSet(
            List.of(new FrameTransform(map, base, Stamp.of(1, 0, ClockKind.ROBOT), RigidTransform.IDENTITY, true)))
            .frames().toList());
  }

  private static boolean namesFrames(Class<?> type) {
    return Data.class.isAssignableFrom(type) && type.isRecord()
        && Stream.of(type.getRecordComponents()).anyMatch(FramedTest::namesFrames);
  }

  private static boolean namesFrames(RecordComponent component) {
    return component.getType() == FrameId.class || elements(component.getGenericType()).anyMatch(FramedTest::hasFrame);
  }

  private static Stream<Class<?>> elements(Type type) {
    return type instanceof ParameterizedType of ? Stream.of(of.getActualTypeArguments()).flatMap(FramedTest::elements)
        : type instanceof Class<?> plain ? Stream.of(plain) : Stream.empty();
  }

  private static boolean hasFrame(Class<?> element) {
    return element == FrameId.class
        || element.isRecord() && Stream.of(element.getRecordComponents())
            .anyMatch(part -> part.getType() == FrameId.class || wraps(part));
  }

  private static boolean wraps(RecordComponent part) {
    return elements(part.getGenericType()).anyMatch(inner -> inner.isRecord()
        && Stream.of(inner.getRecordComponents()).anyMatch(component -> component.getType() == FrameId.class));
  }

  private static Stream<Class<?>> types() throws IOException, URISyntaxException {
    Path folder = Path.of(Data.class.getResource("Data.class").toURI()).getParent();
    try (Stream<Path> files = Files.walk(folder)) {
      return files.map(file -> folder.relativize(file).toString().replace('/', '.'))
          .filter(name -> name.endsWith(".class") && !name.endsWith("package-info.class")).sorted()
          .<Class<?>>map(name -> load(name.substring(0, name.length() - ".class".length()))).toList().stream();
    }
  }

  private static Class<?> load(String name) {
    try {
      return Class.forName("org.robotui.data." + name);
    } catch (ClassNotFoundException e) {
      throw new AssertionError(e);
    }
  }
}
