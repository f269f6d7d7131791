package org.robotui.entity.marker.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.api.command.CommandOutcome;
import org.robotui.data.Data;
import org.robotui.data.marker.Marker;
import org.robotui.data.marker.Marker.Type;
import org.robotui.data.marker.MarkerSet;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayResult;
import org.robotui.gl.display.DisplayStatus;
import org.robotui.gl.shape.Instances;
import org.robotui.gl.shape.Label;
import org.robotui.gl.shape.LineSet;
import org.robotui.gl.shape.Part;
import org.robotui.gl.shape.PointSet;
import org.robotui.gl.shape.Rgba;
import org.robotui.gl.shape.Shape;
import org.robotui.gl.shape.TriangleMesh;
import org.robotui.testkit.SceneImage;
import org.robotui.testkit.ScenePictures;

class MarkersDisplayTest {
  private static final float[] SIX = {0, 0, 0, 1, 0, 0, 1, 1, 0, 2, 1, 0, 3, 1, 0, 3, 2, 0};
  private final Ticks scene = new Ticks(MarkersType.SCHEMA);
  private final Deque<Runnable> background = new ArrayDeque<>();
  private int woken;
  private final MarkersDisplay display = new MarkersDisplay(new DisplayContext() {
    @Override
    public Executor background() {
      return background::add;
    }

    @Override
    public void wake() {
      woken++;
    }

    @Override
    public CommandOutcome send(Data command) {
      throw new AssertionError("markers command nothing");
    }
  });

  private DisplayResult show(Sample... samples) {
    return display.update(scene.of(Sample.set(scene.now, samples)));
  }

  private static Sample[] cubes(int count) {
    return IntStream.range(0, count).mapToObj(i -> Sample.of(i, Type.CUBE)).toArray(Sample[]::new);
  }

  private static Map<Object, Shape> shapes(DisplayResult result) {
    return result.parts().stream().collect(Collectors.toMap(Part::key, Part::shape));
  }

  private static int elements(DisplayResult result) {
    return result.parts().stream().mapToInt(p -> p.shape().elements()).sum();
  }

  private String partly() {
    return assertInstanceOf(DisplayStatus.Partly.class, display.update(scene.of()).status()).words();
  }

  @Test
  void tenThousandCubesAreAHandfulOfPartsAndStayTheSameObjects() {
    DisplayResult first = show(cubes(10_000));
    assertEquals(10_000, elements(first));
    assertTrue(first.parts().size() <= 20, first.parts().size() + " parts");
    assertEquals(new DisplayStatus.Shown("10000 markers: things 10000"), first.status());
    scene.now += 1_000_000;
    DisplayResult again = show(cubes(10_000));
    shapes(first).forEach((key, shape) -> assertSame(shape, shapes(again).get(key), "the same markers said again"));
    DisplayResult changed = show(Sample.of(17, Type.CUBE).scale(2, 2, 2));
    long others =
        shapes(changed).entrySet().stream().filter(e -> shapes(first).get(e.getKey()) != e.getValue()).count();
    assertEquals(1, others, "only the shape with the changed marker is another");
    assertEquals(10_000, elements(changed));
  }

  @Test
  void markersGoWhenTheyAreTakenAwayOrTheirTimeIsOver() {
    show(Sample.of(1, Type.CUBE), Sample.of(2, Type.SPHERE), Sample.of(3, Type.CUBE).living(50));
    assertEquals(3, elements(display.update(scene.of())));
    scene.now += 100;
    assertEquals(2, elements(display.update(scene.of())), "its time is over");
    MarkerSet gone = new MarkerSet(false, List.of(new MarkerSet.Entry(new Marker.Key("things", 1), Optional.empty())));
    assertEquals(1, elements(display.update(scene.of(gone))));
    DisplayResult none = display.update(scene.of(new MarkerSet(true, List.of())));
    assertEquals(0, none.parts().size());
    assertInstanceOf(DisplayStatus.NoData.class, none.status());
    show(cubes(3));
    assertEquals(0, display.update(scene.tick(true)).parts().size(), "the clock jumped back");
  }

  @Test
  void aMarkerMovesWithItsFrameOnlyIfItIsLocked() {
    scene.frames.put("base", RigidTransform.planar(1, 0, 0));
    show(Sample.of(0, Type.CUBE).frame("base", true), Sample.of(0, Type.CUBE).in("still").frame("base", false));
    scene.frames.put("base", RigidTransform.planar(5, 0, 0));
    DisplayResult moved = display.update(scene.of());
    assertEquals(List.of(1.0, 5.0),
        moved.parts().stream().map(p -> p.fixedFromShape().translation().x()).sorted().toList());
    scene.fixed = Ticks.frame("odom");
    assertEquals(List.of(5.0, 5.0),
        display.update(scene.of()).parts().stream().map(p -> p.fixedFromShape().translation().x()).toList(),
        "in another fixed frame it is placed anew");
  }

  @Test
  void aFrameThatNobodyTellsOfIsNamedAndTheMarkerComesWithIt() {
    DisplayResult lost =
        show(Sample.of(0, Type.CUBE).frame("arm", false), Sample.of(1, Type.POINTS).frame("arm", true).points(SIX));
    assertEquals(new DisplayStatus.NoFrame("no transform from arm to map"), lost.status());
    assertEquals(0, lost.parts().size());
    scene.frames.put("arm", RigidTransform.IDENTITY);
    assertEquals(2, display.update(scene.of()).parts().size());
  }

  @Test
  void framesAreAskedForOnceATick() {
    show(cubes(2_000));
    scene.asked = 0;
    display.update(scene.of());
    assertEquals(0, scene.asked, "what stands still is not looked up again");
    show(cubes(2_000));
    assertEquals(1, scene.asked);
  }

  @Test
  void namespacesAreChosen() {
    show(Sample.of(0, Type.CUBE), Sample.of(1, Type.CUBE).in("people"),
        Sample.of(2, Type.TEXT).in("names").saying("x"));
    scene.values.put(MarkersType.HIDDEN, List.of("people"));
    DisplayResult some = display.update(scene.of());
    assertEquals(2, some.parts().size());
    assertEquals("3 markers: names 1, people 1 (hidden), things 1", some.status().words());
    scene.values.put(MarkersType.NAMESPACES, List.of("names"));
    assertEquals(1, display.update(scene.of()).parts().size());
  }

  @Test
  void everyTypeHasItsShape() {
    assertEquals(Instances.class, only(Sample.of(1, Type.ARROW)));
    assertEquals(Instances.class, only(Sample.of(1, Type.CYLINDER)));
    assertEquals(LineSet.class, only(Sample.of(1, Type.LINE_STRIP).scale(0.01, 0, 0).points(SIX)));
    assertEquals(Instances.class, only(Sample.of(1, Type.LINE_LIST).scale(0.1, 0, 0).points(SIX)));
    assertEquals(Instances.class, only(Sample.of(1, Type.CUBE_LIST).points(SIX)));
    assertEquals(Instances.class, only(Sample.of(1, Type.SPHERE_LIST).points(SIX)));
    assertEquals(PointSet.class, only(Sample.of(1, Type.POINTS).points(SIX)));
    assertEquals(Label.class, only(Sample.of(1, Type.TEXT).saying("hello")));
    assertEquals(TriangleMesh.class, only(Sample.of(1, Type.TRIANGLE_LIST).points(SIX)));
  }

  private Class<?> only(Sample sample) {
    DisplayResult result = show(sample);
    assertEquals(1, result.parts().size(), sample.toString());
    assertInstanceOf(DisplayStatus.Shown.class, result.status(), result.status().words());
    return result.parts().getFirst().shape().getClass();
  }

  @Test
  void anArrowBetweenPointsReachesFromOneToTheOther() {
    DisplayResult arrow = show(Sample.of(0, Type.ARROW).scale(0.1, 0.2, 0.5).points(0, 0, 0, 0, 0, 2));
    assertEquals(2, arrow.parts().size(), "shaft and head");
    Instances shaft = (Instances) arrow.parts().getFirst().shape();
    assertEquals(0.75f, shaft.placings().get(2), 1e-6f, "middle of the shaft");
    assertEquals(1.5f, shaft.placings().get(9), 1e-6f, "length of the shaft");
    Instances head = (Instances) arrow.parts().getLast().shape();
    assertEquals(2f, head.placings().get(2), 1e-6f, "the tip");
  }

  @Test
  void whatIsWrongWithAMarkerIsSaidWithItsName() {
    show(Sample.of(4, Type.CUBE).scale(1, 0, 1));
    assertEquals("marker things/4: its scale is 0 in y", partly());
    show(Sample.of(4, Type.CUBE).at(Double.NaN, 0, 0, Quaternion.IDENTITY), Sample.of(5, Type.TEXT));
    assertEquals("marker things/4: its pose is not finite; 1 more with flaws", partly());
    assertEquals(0, display.update(scene.of()).parts().size());
    show(Sample.of(4, Type.CUBE).at(0, 0, 0, new Quaternion(0, 0, 0, 0)), Sample.of(5, Type.CUBE));
    assertEquals("marker things/4: its orientation is all zero, taken as none", partly());
    assertEquals(2, elements(display.update(scene.of())), "it is shown all the same");
    show(Sample.of(4, Type.LINE_LIST).points(1, 2, 3));
    assertTrue(partly().contains("needs pairs of points"), partly());
    show(Sample.of(4, Type.UNKNOWN));
    assertTrue(partly().contains("type is not known"));
  }

  @Test
  void pointsThatAreNotFiniteAreLeftOutOfSolids() {
    DisplayResult crowd = show(Sample.of(1, Type.CUBE_LIST).points(1, 1, 1, Float.NaN, 0, 0, 2, 2, 2));
    Instances cubes = (Instances) crowd.parts().getFirst().shape();
    assertEquals(3, cubes.elements());
    assertEquals(0f, cubes.placings().get(Instances.PLACING + 7), "nothing is seen of it");
  }

  @Test
  void aSelectedSolidSaysWhoItIs() {
    Part part = show(cubes(3)).parts().getFirst();
    assertEquals("Marker things/2", part.describer().describe(2, Vector3.ZERO).title());
    assertEquals("Marker", part.describer().describe(7, Vector3.ZERO).title());
  }

  @Test
  void aMeshIsReadInTheBackgroundAndShownWithItsScale(@TempDir Path folder) throws IOException {
    Files.createDirectories(folder.resolve("p"));
    Files.writeString(folder.resolve("p/package.xml"), "<package><name>p</name></package>");
    Files.writeString(folder.resolve("p/a.stl"),
        "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n");
    scene.values.put(MarkersType.PACKAGES, List.of(folder.toString()));
    DisplayResult waiting = show(Sample.of(1, Type.MESH).scale(2, 2, 2).mesh("package://p/a.stl"));
    assertEquals(0, waiting.parts().size());
    assertEquals("1 marker: things 1; 1 mesh is being read", waiting.status().words());
    background.remove().run();
    assertEquals(1, woken);
    DisplayResult shown = display.update(scene.of());
    Instances mesh = (Instances) shown.parts().getFirst().shape();
    assertEquals(1, mesh.mesh().elements());
    assertEquals(2f, mesh.placings().get(7));
    assertSame(mesh, display.update(scene.of()).parts().getFirst().shape());
    assertEquals("1 marker: things 1", shown.status().words());
  }

  @Test
  void aMeshHasItsPictureWhereTheMarkerTakesItsMaterials(@TempDir Path folder) throws IOException {
    Files.createDirectories(folder.resolve("p"));
    Files.writeString(folder.resolve("p/package.xml"), "<package><name>p</name></package>");
    Files.writeString(folder.resolve("p/a.obj"),
        "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl m\nf 1/1 2/2 3/3\n");
    Files.writeString(folder.resolve("p/a.mtl"), "newmtl m\nKd 0.1 0.2 0.3\nmap_Kd a.png\n");
    ScenePictures.write(folder.resolve("p/a.png"), new SceneImage(2, 1, new int[]{0xff0000, 0x00ff00}));
    scene.values.put(MarkersType.PACKAGES, List.of(folder.toString()));
    show(Sample.of(1, Type.MESH).mesh("package://p/a.obj").withMaterials(),
        Sample.of(2, Type.MESH).mesh("package://p/a.obj"));
    background.remove().run();
    List<Part> parts = display.update(scene.of()).parts();
    assertEquals(2, parts.getFirst().material().texture().orElseThrow().width());
    assertEquals(new Rgba(1, 0, 0, 1), parts.getFirst().material().color(), "the marker's colour tints the picture");
    assertTrue(parts.getLast().material().texture().isEmpty(), "this one has its own colour only");
    Files.delete(folder.resolve("p/a.png"));
    scene.values.put(MarkersType.PACKAGES, List.of(folder.toString(), "/nowhere"));
    display.update(scene.of());
    background.remove().run();
    assertEquals(2, display.update(scene.of()).parts().size());
    assertTrue(partly().contains("its picture 'a.png' is not shown"), partly());
  }

  @Test
  void aMeshThatIsNotThereIsNamedWithTheRemedy() {
    scene.values.put(MarkersType.PACKAGES, List.of("/nowhere"));
    show(Sample.of(1, Type.MESH).mesh("package://p/a.dae"), Sample.of(2, Type.CUBE));
    background.remove().run();
    assertTrue(partly().startsWith("marker things/1: the package 'p' is not in "), partly());
    assertEquals(1, display.update(scene.of()).parts().size(), "the others are shown");
    show(Sample.of(1, Type.MESH).mesh("http://somewhere/a.dae"));
    background.remove().run();
    assertTrue(partly().contains("nothing is fetched from elsewhere"), partly());
  }

  @ParameterizedTest
  @ValueSource(strings = {"file:///etc/passwd", "/etc/passwd", "package://p/../secret.stl", "package:///etc/passwd",
      "https://somewhere/a.stl"})
  void nothingIsReadOutsideOfPackages(String uri, @TempDir Path folder) throws IOException {
    Files.createDirectories(folder.resolve("p"));
    Files.writeString(folder.resolve("p/package.xml"), "<package><name>p</name></package>");
    Files.writeString(folder.resolve("secret.stl"), "solid s\nendsolid s\n");
    scene.values.put(MarkersType.PACKAGES, List.of(folder.toString()));
    show(Sample.of(1, Type.MESH).mesh(uri));
    background.remove().run();
    assertEquals(0, display.update(scene.of()).parts().size());
    assertTrue(partly().startsWith("marker things/1: "), partly());
  }

  @Test
  void aMillionPointsAreOneShape() {
    DisplayResult crowd = show(Sample.of(1, Type.POINTS).scale(0.1, 0.1, 0).points(new float[3_000_000]));
    assertEquals(1, crowd.parts().size());
    assertEquals(1_000_000, crowd.parts().getFirst().shape().elements());
  }

  @Test
  void tooManyAreCountedAndSaid() {
    DisplayResult many = show(cubes(MarkerStore.MOST + 3));
    assertEquals(3, many.dropped());
    assertTrue(many.status().words().contains("more than 100000 markers"), many.status().words());
    display.close();
  }
}
