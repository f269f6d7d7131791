package org.robotui.install;

/** An OSGi service that is told what the running application takes up by itself. */
@FunctionalInterface
public interface InstallListener {
  /**
   * A bundle has come or gone that nobody here asked for: by the folder, or by another process that changed the
   * product. Called on the thread that watches.
   *
   * @param sentence for users
   * @param trouble true where something is wrong
   */
  void said(String sentence, boolean trouble);
}
