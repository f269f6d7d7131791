package org.robotui.core.internal.watch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class BlameTest {
  private static final BundleNames NAMES = name -> Stream.of(
      "org.robotui.workbench", "org.robotui.ui", "org.robotui.uic.map", "org.robotui.entity.gridmap", "org.eclipse.swt",
      "com.example.view")
      .filter(b -> name.startsWith(b + ".")).findFirst();

  private static Optional<String> blamed(String... classes) {
    StackTraceElement[] stack = Stream.of(classes)
        .map(c -> new StackTraceElement(c, "run", "File.java", 1)).toArray(StackTraceElement[]::new);
    return Blame.of(stack, NAMES).map(Blame::bundle);
  }

  @Test
  void namesTheTopmostBundleThatIsNoCommonCaller() {
    assertEquals(Optional.of("org.robotui.entity.gridmap"), blamed("java.lang.Thread", "org.eclipse.swt.Gc",
        "org.robotui.ui.Painter", "org.robotui.entity.gridmap.GridMapEntity", "org.robotui.uic.map.MapView",
        "org.robotui.workbench.ViewPart"));
    assertEquals(Optional.of("com.example.view"), blamed("com.example.view.View", "org.robotui.workbench.ViewPart"));
  }

  @Test
  void namesOursWhereNoViewIsOnTheStack() {
    assertEquals(Optional.of("org.robotui.workbench"), blamed("org.eclipse.swt.Gc", "org.robotui.workbench.ViewPart"));
  }

  @Test
  void namesNobodyOnAForeignStack() {
    assertTrue(blamed("java.lang.Object", "org.eclipse.swt.Display").isEmpty());
  }

  @Test
  void asksForNoNameBelowTheOneToBlame() {
    StackTraceElement[] stack = {new StackTraceElement("org.robotui.uic.map.MapView", "run", "File.java", 1),
        new StackTraceElement("java.lang.Thread", "run", "File.java", 1)};
    List<String> asked = new ArrayList<>();
    Blame.of(stack, name -> {
      asked.add(name);
      return NAMES.bundleOf(name);
    });
    assertEquals(List.of("org.robotui.uic.map.MapView"), asked);
  }
}
