package org.robotui.install.internal;

import org.eclipse.core.runtime.NullProgressMonitor;
import org.robotui.install.InstallWatcher;

/** Tells a watcher what p2 says that it does. */
final class StepMonitor extends NullProgressMonitor {
  private final InstallWatcher watcher;
  private String last = "";

  StepMonitor(InstallWatcher watcher) {
    this.watcher = watcher;
  }

  @Override
  public void beginTask(String name, int totalWork) {
    tell(name);
  }

  @Override
  public void setTaskName(String name) {
    tell(name);
  }

  @Override
  public void subTask(String name) {
    tell(name);
  }

  private void tell(String name) {
    String words = name == null ? "" : name.strip();
    if (!words.isEmpty() && !words.equals(last)) {
      last = words;
      watcher.step(words);
    }
  }
}
