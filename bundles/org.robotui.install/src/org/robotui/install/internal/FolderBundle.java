package org.robotui.install.internal;

import java.nio.file.Path;
import java.util.Optional;
import org.osgi.framework.Bundle;

/** A jar of the folder, and what has become of it. Only the thread that watches uses it. */
final class FolderBundle {
  private FileStamp seen;
  private FileStamp taken;
  private Bundle bundle;
  private Path copy;
  private String trouble = "";
  private boolean waiting;

  /** Looks again; true where the file is another one than that which was taken, and nobody writes it any more. */
  boolean isDue(FileStamp now, boolean settled) {
    boolean still = now.equals(seen);
    seen = now;
    boolean lost = bundle != null && bundle.getState() == Bundle.UNINSTALLED;
    return (still || settled) && (!now.equals(taken) || lost);
  }

  /** It was looked into, whatever has become of it. */
  void taken(FileStamp stamp) {
    taken = stamp;
  }

  void installed(Bundle made, Path from) {
    bundle = made;
    copy = from;
  }

  /** The bundle that it is; none where it is none, or was uninstalled. */
  Optional<Bundle> bundle() {
    return Optional.ofNullable(bundle).filter(each -> each.getState() != Bundle.UNINSTALLED);
  }

  Optional<Path> copy() {
    return Optional.ofNullable(copy);
  }

  /** Whether it is installed, but lacks something. */
  boolean isWaiting() {
    return waiting;
  }

  void waiting(boolean lacks) {
    waiting = lacks;
  }

  void gone() {
    bundle = null;
    copy = null;
  }

  /** Remembers what is wrong with it; true where that is news. */
  boolean troubled(String sentence) {
    boolean news = !sentence.equals(trouble);
    trouble = sentence;
    return news;
  }

  String trouble() {
    return trouble;
  }
}
