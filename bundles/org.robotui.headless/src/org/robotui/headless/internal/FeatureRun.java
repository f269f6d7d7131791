package org.robotui.headless.internal;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.net.URI;
import java.util.List;
import org.robotui.install.FeatureInstaller;
import org.robotui.install.InstallOutcome;
import org.robotui.install.InstallWatcher;
import org.robotui.install.SiteContent;
import org.robotui.install.SiteFeature;

/** Installs, updates and removes features, and ends. What was done goes to the output, what is asked beside it. */
final class FeatureRun {
  private final FeatureInstaller installer;
  private final PrintStream out;
  private final PrintStream err;
  private final BufferedReader answers;

  FeatureRun(FeatureInstaller installer, PrintStream out, PrintStream err, BufferedReader answers) {
    this.installer = installer;
    this.out = out;
    this.err = err;
    this.answers = answers;
  }

  Exit run(FeatureArguments wanted) {
    return switch (wanted.verb()) {
      case INSTALLED -> list(installer.installed());
      case INSTALL -> install(wanted.site().orElseThrow(), wanted);
      case UPDATE -> told(installer.update(wanted.features(), watcher(wanted)));
      case REMOVE -> told(installer.remove(wanted.features(), watcher(wanted)));
    };
  }

  /** A site with one feature needs no name; of others the user has to choose. */
  private Exit install(URI site, FeatureArguments wanted) {
    if (!wanted.features().isEmpty()) {
      return told(installer.install(site, wanted.features(), watcher(wanted)));
    }
    return switch (installer.look(site)) {
      case SiteContent.Unreadable unreadable -> refused(unreadable.sentence());
      case SiteContent.Offered offered when offered.features().size() == 1 -> told(
          installer.install(site, List.of(offered.features().getFirst().id()), watcher(wanted)));
      case SiteContent.Offered offered -> {
        list(offered.features());
        yield refused(offered.features().isEmpty() ? site + " offers no features."
            : "Say which of these features of the site to install.");
      }
    };
  }

  private Exit list(List<SiteFeature> features) {
    int width = features.stream().mapToInt(feature -> feature.id().length()).max().orElse(1);
    features.forEach(feature -> out.println(
        String.format("%-" + width + "s  %s  %s", feature.id(), feature.version(), feature.name())));
    return Exit.FINE;
  }

  private Exit told(InstallOutcome outcome) {
    if (outcome instanceof InstallOutcome.Refused refused) {
      return refused(refused.sentence());
    }
    out.println(outcome.sentence());
    return Exit.FINE;
  }

  private Exit refused(String sentence) {
    err.println(sentence);
    return Exit.ERRORS;
  }

  private InstallWatcher watcher(FeatureArguments wanted) {
    return new InstallWatcher() {
      @Override
      public boolean acceptsUnsigned(List<String> names) {
        return wanted.unsigned() || asked(names);
      }

      @Override
      public void step(String what) {
        // A terminal is told what has become of it, not every step.
      }
    };
  }

  private boolean asked(List<String> names) {
    err.println("Nobody has signed " + String.join(", ", names)
        + ". What it holds can do all that you can do on this machine.");
    err.print("Install it all the same? [y/N] ");
    err.flush();
    try {
      String answer = answers.readLine();
      err.println(answer == null ? "(there is nobody to answer: --unsigned installs it without asking)" : "");
      return answer != null && answer.strip().toLowerCase(java.util.Locale.ROOT).matches("y|yes");
    } catch (IOException e) {
      return false;
    }
  }
}
