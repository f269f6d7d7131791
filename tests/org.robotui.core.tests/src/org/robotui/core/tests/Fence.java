package org.robotui.core.tests;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.osgi.framework.Bundle;
import org.robotui.api.UicType.Surface;
import org.robotui.api.command.Principal;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicState;

/**
 * A component of the bundle that misbehaves in the RUIC Keira, beside a healthy robot interface and a healthy view, and
 * beside a second, healthy RUIC. Ends what never ends by itself.
 */
final class Fence implements AutoCloseable {
  static final String OVER = "robotui.tests.over";
  static final Principal WINDOW = new Principal("window", "You", Principal.Kind.WINDOW);

  private static final String HEALTHY = """
      ruics:
        Lara:
          rfics:
            base: otherwheels
          uics:
            pulse: otherpulse
        Keira:
          safety:
            Keira: {lease: false%s}
          rfics:
            base: wheels
      %s
          uics:
            pulse: pulse
      %s
      """;

  final Wheels wheels = new Wheels("wheels");
  final World world;
  private final Pulse pulse = new Pulse("pulse", false);
  private final Pulse other = new Pulse("otherpulse", false);
  private final Bundle bundle;

  Fence(Path folder) throws Exception {
    System.clearProperty(OVER);
    world = new World(folder);
    bundle = BadBundle.packed().install();
    world.bring(wheels);
    world.bring(new Wheels("otherwheels"));
    world.bring(pulse);
    world.bring(other);
    world.core().open(Surface.TEXT, WINDOW);
  }

  /** With a view that does something in some method. */
  Fence view(String settings) throws IOException {
    return load("", "      bad: {type: badview, " + settings + "}");
  }

  /** With a robot interface that does something in some method; it is of a robot of its own. */
  Fence robot(String settings) throws IOException {
    return load("      bad: {type: badrobot, " + settings + "}", "      none: text");
  }

  Fence load(String rfics, String uics) throws IOException {
    return load(rfics, uics, "");
  }

  Fence load(String rfics, String uics, String safety) throws IOException {
    world.load(HEALTHY.formatted(safety.isEmpty() ? "" : ", " + safety, rfics, uics));
    world.core().ruics().forEach(r -> r.select("window"));
    return this;
  }

  Ruic keira() {
    return world.core().ruics().stream().filter(r -> r.name().equals("Keira")).findFirst().orElseThrow();
  }

  /** The healthy ones get values, from now on. */
  void assertTheOthersGoOn() {
    pulse.awaitMore();
    other.awaitMore();
    world.await("base", RuicState.INITIALIZED);
    world.await("pulse", RuicState.SELECTED);
  }

  /** Waits until the bad component has failed, and says what the user reads. */
  String awaitFenced() {
    world.await("bad", RuicState.FAILED);
    world.awaitAlert("Keira: bad failed: "); // by then it is known what could not be ended
    return world.reason("bad");
  }

  /** What was left when all had ended. */
  List<String> close(Duration limit) {
    return world.core().close(limit);
  }

  @Override
  public void close() throws Exception {
    System.setProperty(OVER, "true");
    world.close();
    bundle.uninstall();
    world.awaitNoThread("Keira", "Lara", "leaked-");
  }
}
