package org.robotui.uic.teleop.internal;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.config.SettingsStore;
import org.robotui.ui.Icon;
import org.robotui.ui.SurfaceUic;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewKey;

/** The view: a driver that the tick lets send, and a surface while it is shown. */
final class TeleopUic extends SurfaceUic<TeleopSurface> {
  private final Driver driver;
  private final SettingsStore settings;
  private final Executor background;
  private final AtomicBoolean following = new AtomicBoolean();
  private Optional<TeleopViewState> shown = Optional.empty();

  TeleopUic(Driver driver, SettingsStore settings, Executor background) {
    this.driver = driver;
    this.settings = settings;
    this.background = background;
    offers().add("gamepad", "Drive by gamepad", Icon.STEER, () -> mapping().isUsed(), this::usePad);
    follow();
  }

  private PadMapping mapping() {
    return PadMapping.of(settings.current());
  }

  private void usePad() {
    settings.set(PadMapping.DEVICE, mapping().isUsed() ? "" : PadMapping.AUTO);
    driver.padEnd(System.nanoTime());
    follow();
  }

  /** Follows the gamepad as long as one is wanted. */
  private void follow() {
    if (mapping().isUsed() && following.compareAndSet(false, true)) {
      background.execute(() -> {
        try {
          new PadFollower(driver, this::mapping, System::nanoTime).run();
        } finally {
          following.set(false);
        }
      });
    }
  }

  @Override
  public boolean tick(long nowNanos) {
    driver.tick(nowNanos);
    Optional<TeleopViewState> next = Optional.of(driver.look(nowNanos));
    boolean changed = !next.equals(shown);
    shown = next;
    return changed;
  }

  @Override
  protected TeleopSurface open(Composite parent, UiContext ui) {
    return new TeleopSurface(parent, ui, driver, settings);
  }

  @Override
  protected void refresh(TeleopSurface shown) {
    shown.refresh();
  }

  @Override
  public List<ViewKey> keys() {
    return List.of(
        new ViewKey("W A S D", "Drive, while held"),
        new ViewKey("Arrows", "Drive, while held"),
        new ViewKey("Q, E", "Turn, while held"),
        new ViewKey("Shift", "Halve the speed"),
        new ViewKey("Space", "Stop"),
        new ViewKey("Esc", "Let go"));
  }

  @Override
  public void close() {
    driver.leave();
  }
}
