package org.robotui.workbench.tests;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.RGB;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.ui.IWorkbenchWindow;
import org.eclipse.ui.PlatformUI;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.osgi.framework.Bundle;
import org.osgi.framework.BundleContext;
import org.osgi.framework.FrameworkUtil;
import org.robotui.api.host.Host;
import org.robotui.api.host.Problem;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicState;
import org.robotui.testkit.osgi.PackedBundle;

/**
 * A bundle that comes while the workbench runs, with data that nobody knew and what shows them: they are seen in the
 * views that were there before, and no more when it has gone. Runs on the display thread.
 */
class NoveltyTest {
  private static final Duration PATIENCE = Duration.ofSeconds(40);
  private static final String NAME = "org.robotui.tests.novelty";
  private static final String IMPORTS = String.join(",", "org.osgi.framework", "org.robotui.api",
      "org.robotui.api.config", "org.robotui.api.link", "org.robotui.api.port", "org.robotui.data",
      "org.robotui.data.sensor", "org.robotui.geometry", "org.robotui.gl.display", "org.robotui.gl.shape",
      "org.robotui.ui", "org.robotui.ui.layer", "org.robotui.ui.scene");
  /** So many pixels of its colour are no accident. */
  private static final int SEEN = 100;
  private static final long LOOK_NANOS = 200_000_000L;

  private final Host host = service(Host.class);
  private final IWorkbenchWindow window = PlatformUI.getWorkbench().getWorkbenchWindows()[0];
  private @TempDir Path folder;
  private Optional<Bundle> novelty = Optional.empty();

  @AfterEach
  void end() throws Exception {
    host.ruics().forEach(Ruic::remove);
    until(() -> host.ruics().isEmpty() && stacks() == 0, "the robot is removed, also from the window");
    leave();
  }

  @Test
  void itIsSeenInAMap() throws Exception {
    comesAndGoes("map");
  }

  @Test
  void itIsSeenOnTheEarth() throws Exception {
    comesAndGoes("gps");
  }

  @Test
  void itIsSeenInSpace() throws Exception {
    comesAndGoes("scene3d");
  }

  private void comesAndGoes(String view) throws Exception {
    show(view);
    assertFalse(isSeen(), "before it came");
    come();
    untilSeen(true, "it is seen");
    leave();
    untilSeen(false, "it is seen no more");
    assertTrue(isSelected(), host.ruics().getFirst().snapshot()::toString);
    come();
    untilSeen(true, "it is seen again");
  }

  private void come() throws Exception {
    novelty = Optional.of(new PackedBundle(FrameworkUtil.getBundle(NoveltyTest.class), NAME, Map.of("Import-Package",
        IMPORTS, "Require-Bundle", "org.eclipse.swt", "Bundle-Activator", NAME + ".NoveltyActivator")).install());
  }

  private void leave() throws Exception {
    if (novelty.isPresent()) {
      novelty.get().uninstall();
      novelty = Optional.empty();
    }
  }

  private void show(String type) throws Exception {
    Path file = Files.writeString(folder.resolve("boat.yaml"), """
        ruics:
          Boat with %s:
            rfics:
              base: {type: boat}
            uics:
              view: {type: %s}
            layout: {view: view}
        """.formatted(type, type));
    CompletableFuture<List<Problem>> problems = CompletableFuture.supplyAsync(() -> host.load(file));
    until(problems::isDone, "the file is read");
    until(() -> {
      boolean shown = isSelected() && stacks() == 1;
      if (!shown) {
        Driver.pressFirstRobot(window);
      }
      return shown;
    }, "the view is shown");
  }

  private boolean isSelected() {
    return host.ruics().stream().flatMap(ruic -> ruic.snapshot().components().stream())
        .anyMatch(c -> c.id().equals("view") && c.state() == RuicState.SELECTED);
  }

  private int stacks() {
    return Driver.widgets(window, "ViewStack").size();
  }

  /** Waits until its colour is in the window, or is not. Looks now and then only, so that the window comes to paint. */
  private void untilSeen(boolean wanted, String what) {
    long[] looked = {System.nanoTime()};
    until(() -> {
      long now = System.nanoTime();
      boolean due = now - looked[0] > LOOK_NANOS;
      boolean is = due && isSeen() == wanted;
      looked[0] = due ? System.nanoTime() : looked[0];
      return is;
    }, what);
  }

  /** Whether its colour is in the window. */
  private boolean isSeen() {
    ImageData picture = picture(window.getShell());
    int found = 0;
    for (int y = 0; y < picture.height; y += 2) {
      for (int x = 0; x < picture.width; x += 2) {
        RGB rgb = picture.palette.getRGB(picture.getPixel(x, y));
        found += rgb.red > 200 && rgb.green < 60 && rgb.blue > 200 ? 1 : 0;
      }
    }
    return found > SEEN;
  }

  private static ImageData picture(Shell shell) {
    Image image = new Image(shell.getDisplay(), shell.getSize().x, shell.getSize().y);
    GC gc = new GC(shell);
    gc.copyArea(image, 0, 0);
    gc.dispose();
    ImageData data = image.getImageData();
    image.dispose();
    return data;
  }

  private void until(BooleanSupplier condition, String what) {
    Driver.until(PATIENCE, condition, () -> what + "; there is " + host.ruics().stream().map(Ruic::snapshot).toList());
  }

  private static <S> S service(Class<S> type) {
    BundleContext context = FrameworkUtil.getBundle(NoveltyTest.class).getBundleContext();
    return Optional.ofNullable(context.getServiceReference(type)).map(context::getService).orElseThrow();
  }
}
