package org.robotui.install;

import java.util.List;

/** Who follows an installation, and answers what only a user can. Called on the thread that installs. */
public interface InstallWatcher {
  /**
   * Asks whether to install what nobody has signed.
   *
   * @param names of the files that are not signed
   * @return true to install them; otherwise nothing is installed
   */
  boolean acceptsUnsigned(List<String> names);

  /**
   * Tells what is being done.
   *
   * @param what in a few words
   */
  void step(String what);
}
