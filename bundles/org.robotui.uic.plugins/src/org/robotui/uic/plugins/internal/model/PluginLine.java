package org.robotui.uic.plugins.internal.model;

import java.util.Optional;
import org.robotui.data.control.ControlPlugins.Plugin;
import org.robotui.data.control.ControlPlugins.State;
import org.robotui.ui.Health;

/**
 * A plugin.
 *
 * @param plugin what is known of it
 * @param busy how long one call took
 * @param pending whether the control was asked something that it has not answered yet
 */
public record PluginLine(Plugin plugin, Evidence busy, boolean pending) implements Line {
  /** How a plugin stands in the list. */
  static PluginLine of(Plugin plugin, Optional<Plugin> earlier, boolean pending) {
    return new PluginLine(plugin, Evidence.of(plugin.busy(), earlier.map(Plugin::busy)), pending);
  }

  @Override
  public String key() {
    return key(plugin.name());
  }

  static String key(String name) {
    return "plugin " + name;
  }

  @Override
  public String name() {
    return plugin.name();
  }

  @Override
  public long period() {
    return plugin.period();
  }

  @Override
  public Health health() {
    return switch (plugin.state()) {
      case RUNNING -> busy.share(period()) >= 1 ? Health.WARNING : Health.OK;
      case STARTING, STOPPING, LOADED -> Health.WAITING;
      // One whose process died is stopped when that is there again: what was wrong is to be seen until it is started or
      // loaded anew.
      case STOPPED -> plugin.error().isBlank() ? Health.NONE : Health.BAD;
      case ABSENT -> Health.WARNING;
      case FAILED -> Health.BAD;
    };
  }

  @Override
  public String word() {
    return switch (plugin.state()) {
      case ABSENT -> "no process";
      case LOADED -> "loaded";
      case STOPPED -> "stopped";
      case STARTING -> "starting";
      case RUNNING -> "running";
      case STOPPING -> "stopping";
      case FAILED -> "failed";
    };
  }

  @Override
  public String words() {
    return plugin.error().isBlank() ? plugin.status() : plugin.error().lines().findFirst().orElse("");
  }

  /** Whether its switch is on: it runs, or is on its way there. */
  public boolean isOn() {
    return plugin.state() == State.RUNNING || plugin.state() == State.STARTING;
  }

  /** Whether its switch is between off and on. */
  public boolean isTurning() {
    return pending || plugin.state() == State.STARTING || plugin.state() == State.STOPPING;
  }

  /** Whether it can be switched: what failed or has no process has to be loaded first. */
  public boolean isSwitchable() {
    return !pending
        && (plugin.state() == State.STOPPED || plugin.state() == State.RUNNING || plugin.state() == State.STARTING);
  }

  /** Whether it can be loaded anew: it must not run. */
  public boolean isReloadable() {
    return !pending
        && (plugin.state() == State.STOPPED || plugin.state() == State.FAILED || plugin.state() == State.LOADED);
  }
}
