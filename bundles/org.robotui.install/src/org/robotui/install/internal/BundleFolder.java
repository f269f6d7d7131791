package org.robotui.install.internal;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.osgi.framework.Bundle;
import org.osgi.framework.BundleException;
import org.robotui.install.InstallListener;

/**
 * A folder whose jars are bundles of the running application. A jar that comes is installed and started, one that
 * changes replaces what it was, one that goes is uninstalled. Bundles run from copies, as a build may write a jar while
 * its classes are read. They are uninstalled with the end of the application: the framework keeps nothing of them.
 */
final class BundleFolder implements AutoCloseable {
  /** By this the framework knows bundles of the folder, also those of other processes that share what it keeps. */
  private static final String LOCATION = "robotui-bundles:";

  private final Path folder;
  private final Path copies;
  private final Framework framework;
  private final InstallListener listener;
  private final Map<Path, FolderBundle> known = new TreeMap<>();
  private int number;

  BundleFolder(Path folder, Path copies, Framework framework, InstallListener listener) {
    this.folder = folder;
    this.copies = copies;
    this.framework = framework;
    this.listener = listener;
  }

  /** Forgets what a killed run has left, and what another one has now: the framework keeps one list for all. */
  void clear() throws InterruptedException {
    List<Bundle> left = new ArrayList<>();
    for (Bundle bundle : framework.all()) {
      if (bundle.getLocation().startsWith(LOCATION)) {
        uninstall(bundle);
        left.add(bundle);
      }
    }
    if (!left.isEmpty()) {
      framework.refresh(left);
    }
    for (Path copy : jars(copies)) {
      delete(copy);
    }
  }

  /** Looks once, and takes up what has changed and is whole. */
  void scan() throws InterruptedException {
    List<Bundle> replaced = new ArrayList<>();
    List<Path> changed = new ArrayList<>();
    List<Path> files = jars(folder);
    leave(files, replaced);
    for (Path file : files) {
      FolderBundle entry = known.computeIfAbsent(file, f -> new FolderBundle());
      Optional<FileStamp> stamp = FileStamp.of(file);
      if (stamp.isPresent() && entry.isDue(stamp.get(), stamp.get().isSettled(Instant.now()))) {
        if (take(file, entry, stamp.get(), replaced)) {
          changed.add(file);
        }
      }
    }
    if (!replaced.isEmpty()) {
      framework.refresh(replaced);
    }
    if (!changed.isEmpty() || !replaced.isEmpty()) {
      start(changed);
    }
  }

  private void leave(List<Path> files, List<Bundle> replaced) {
    for (Iterator<Map.Entry<Path, FolderBundle>> all = known.entrySet().iterator(); all.hasNext();) {
      Map.Entry<Path, FolderBundle> each = all.next();
      if (!files.contains(each.getKey())) {
        each.getValue().bundle().ifPresent(bundle -> listener
            .said("Removed " + label(bundle) + ": " + name(each.getKey()) + " has gone.", false));
        end(each.getValue(), replaced);
        all.remove();
      }
    }
  }

  /** Where the file is of no use, what was taken of it before goes on. */
  private boolean take(Path file, FolderBundle entry, FileStamp stamp, List<Bundle> replaced) {
    entry.taken(stamp);
    try {
      Files.createDirectories(copies);
      Path copy = copies.resolve(++number + "-" + name(file));
      Files.copy(file, copy, StandardCopyOption.REPLACE_EXISTING);
      install(entry, copy, replaced);
      return true;
    } catch (IOException | BundleException e) {
      trouble(file, entry, "cannot be taken: " + e.getMessage());
    } catch (BundleJar.Unusable e) {
      trouble(file, entry, e.getMessage() + ". It is looked at again when it changes");
    }
    return false;
  }

  private void install(FolderBundle entry, Path copy, List<Bundle> replaced)
      throws BundleJar.Unusable, BundleException, IOException {
    BundleJar jar = BundleJar.read(copy);
    Optional<Bundle> other = framework.other(jar.name(), entry.bundle());
    if (other.isPresent()) {
      delete(copy);
      throw new BundleJar.Unusable("is " + jar.label() + ", and " + label(other.get())
          + " is installed already: remove one of them");
    }
    end(entry, replaced);
    entry.installed(framework.install(LOCATION + copy, copy), copy);
  }

  private void end(FolderBundle entry, List<Bundle> replaced) {
    entry.bundle().ifPresent(bundle -> {
      uninstall(bundle);
      replaced.add(bundle);
    });
    entry.copy().ifPresent(BundleFolder::delete);
    entry.gone();
  }

  /** Also those that could not start before: what was missing may have come with another jar. */
  private void start(List<Path> changed) {
    known.forEach((file, entry) -> entry.bundle().filter(bundle -> entry.isWaiting() || changed.contains(file))
        .ifPresent(bundle -> start(file, entry, bundle)));
  }

  private void start(Path file, FolderBundle entry, Bundle bundle) {
    Optional<String> reason = framework.start(bundle);
    entry.waiting(reason.isPresent());
    if (reason.isPresent()) {
      trouble(file, entry, "is installed, but cannot be started: " + reason.get());
    } else {
      entry.troubled("");
      listener.said("Installed " + label(bundle) + " from " + file + ".", false);
    }
  }

  private void trouble(Path file, FolderBundle entry, String what) {
    String sentence = file + " " + what + ".";
    if (entry.troubled(sentence)) {
      listener.said(sentence, true);
    }
  }

  /** What is wrong at present, for those who come later. */
  List<String> troubles() {
    return known.values().stream().map(FolderBundle::trouble).filter(sentence -> !sentence.isEmpty()).toList();
  }

  @Override
  public void close() {
    List<Bundle> gone = new ArrayList<>();
    known.values().forEach(entry -> end(entry, gone));
    known.clear();
  }

  private void uninstall(Bundle bundle) {
    try {
      bundle.uninstall();
    } catch (BundleException | IllegalStateException e) {
      listener.said(label(bundle) + " cannot be uninstalled: " + e.getMessage() + ".", true);
    }
  }

  private static List<Path> jars(Path folder) {
    List<Path> jars = new ArrayList<>();
    if (Files.isDirectory(folder)) {
      try (DirectoryStream<Path> all = Files.newDirectoryStream(folder, "*.jar")) {
        for (Path file : all) {
          if (Files.isRegularFile(file)) {
            jars.add(file);
          }
        }
      } catch (IOException e) {
        return List.of(); // it has gone meanwhile, or cannot be read: then there is nothing in it for us
      }
    }
    return jars;
  }

  private static void delete(Path copy) {
    try {
      Files.deleteIfExists(copy);
    } catch (IOException e) {
      copy.toFile().deleteOnExit();
    }
  }

  private static String label(Bundle bundle) {
    return bundle.getSymbolicName() + " " + bundle.getVersion();
  }

  private static String name(Path file) {
    return file.getFileName().toString();
  }
}
