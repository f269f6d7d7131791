package org.robotui.workbench.internal.model;

import java.net.URI;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.robotui.install.FeatureInstaller;
import org.robotui.install.InstallOutcome;
import org.robotui.install.InstallWatcher;
import org.robotui.install.SiteContent;
import org.robotui.install.SiteFeature;
import org.robotui.ui.Health;

/**
 * What the user sees of installing: sites, features, what is being done and what has become of it. Display thread only;
 * the installer is called on another one.
 */
public final class SoftwareModel {
  private final FeatureInstaller installer;
  private final Executor background;
  private final Executor display;
  private final Predicate<List<String>> accepts;
  private Runnable changed = () -> {};
  private List<SiteFeature> installed = List.of();
  private List<SiteFeature> offered = List.of();
  private Optional<URI> site;
  private boolean busy;
  private Health health = Health.NONE;
  private String sentence = "";

  /**
   * Looks at nothing yet.
   *
   * @param installer does it
   * @param background runs what takes long, off the display thread
   * @param display runs tasks on the display thread
   * @param accepts asks whether to install what nobody has signed, with the names of the files; called on the
   * background
   */
  public SoftwareModel(FeatureInstaller installer, Executor background, Executor display,
      Predicate<List<String>> accepts) {
    this.installer = installer;
    this.background = background;
    this.display = display;
    this.accepts = accepts;
    site = installer.sites().stream().findFirst();
  }

  /** Has something run after each change. */
  public void onChange(Runnable action) {
    changed = action;
  }

  /** The sites of this user. */
  public List<URI> sites() {
    return installer.sites();
  }

  /** The site that is looked at. */
  public Optional<URI> site() {
    return site;
  }

  /** What is installed and offered. */
  public List<FeatureRow> rows() {
    return FeatureRow.of(installed, offered);
  }

  /** Whether something is being done, so that nothing else can be begun. */
  public boolean isBusy() {
    return busy;
  }

  /** How what was done last has ended. */
  public Health health() {
    return health;
  }

  /** What is being done, or what has become of it. */
  public String sentence() {
    return sentence;
  }

  /** What is written of an address that a user has typed, where it is none. */
  public static boolean isSite(String text) {
    try {
      return URI.create(text.strip()).isAbsolute() && text.strip().matches("(https?|file):.+");
    } catch (IllegalArgumentException e) {
      return false;
    }
  }

  /** Looks at a site, and remembers it. */
  public void choose(URI wanted) {
    installer.remember(wanted);
    site = Optional.of(wanted);
    look();
  }

  /** Forgets the site that is looked at; what was installed from it stays. */
  public void forget() {
    site.ifPresent(installer::forget);
    site = installer.sites().stream().findFirst();
    look();
  }

  /** Reads what is installed and what the site offers. */
  public void look() {
    Optional<URI> at = site;
    run(at.map(where -> "Reading " + where).orElse("Reading what is installed"), () -> {
      List<SiteFeature> have = installer.installed();
      Optional<SiteContent> content = at.map(installer::look);
      return () -> read(have, content);
    });
  }

  private void read(List<SiteFeature> have, Optional<SiteContent> content) {
    installed = have;
    switch (content.orElse(new SiteContent.Offered(List.of()))) {
      case SiteContent.Offered of -> {
        offered = of.features();
        say(Health.NONE, "");
      }
      case SiteContent.Unreadable not -> {
        offered = List.of();
        say(Health.BAD, not.sentence());
      }
    }
  }

  /** Installs what the site offers, or its newer version. */
  public void install(FeatureRow row) {
    site.ifPresent(from -> change("Installing " + row.name(),
        watcher -> installer.install(from, List.of(row.id()), watcher)));
  }

  /** Updates all that any of the sites has in a newer version. */
  public void update() {
    change("Looking for updates", watcher -> installer.update(List.of(), watcher));
  }

  /** Removes what is installed. */
  public void remove(FeatureRow row) {
    change("Removing " + row.name(), watcher -> installer.remove(List.of(row.id()), watcher));
  }

  private void change(String doing, Function<InstallWatcher, InstallOutcome> work) {
    run(doing, () -> {
      InstallOutcome outcome = work.apply(watcher(doing));
      List<SiteFeature> have = installer.installed();
      return () -> {
        installed = have;
        say(switch (outcome) {
          case InstallOutcome.Changed done -> done.restart() ? Health.WARNING : Health.OK;
          case InstallOutcome.Unchanged same -> Health.NONE;
          case InstallOutcome.Refused not -> Health.BAD;
        }, outcome.sentence());
      };
    });
  }

  private InstallWatcher watcher(String doing) {
    return new InstallWatcher() {
      @Override
      public boolean acceptsUnsigned(List<String> names) {
        return accepts.test(names);
      }

      @Override
      public void step(String what) {
        display.execute(() -> {
          if (busy) {
            say(Health.WAITING, doing + ": " + what);
            changed.run();
          }
        });
      }
    };
  }

  /** Work that gives what is to be done on the display thread. */
  private void run(String doing, Supplier<Runnable> work) {
    if (busy) {
      return;
    }
    busy = true;
    say(Health.WAITING, doing);
    changed.run();
    CompletableFuture.supplyAsync(work, background).whenCompleteAsync((done, failure) -> {
      busy = false;
      if (failure == null) {
        done.run();
      } else {
        say(Health.BAD, doing + " has failed: " + failure.getMessage());
      }
      changed.run();
    }, display);
  }

  private void say(Health how, String words) {
    health = how;
    sentence = words;
  }
}
