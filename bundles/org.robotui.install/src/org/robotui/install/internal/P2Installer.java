package org.robotui.install.internal;

import java.io.IOException;
import java.net.URI;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.equinox.p2.core.IProvisioningAgentProvider;
import org.eclipse.equinox.p2.core.ProvisionException;
import org.eclipse.equinox.p2.core.UIServices;
import org.eclipse.equinox.p2.metadata.IInstallableUnit;
import org.eclipse.equinox.p2.operations.InstallOperation;
import org.eclipse.equinox.p2.operations.ProfileChangeOperation;
import org.eclipse.equinox.p2.operations.UninstallOperation;
import org.eclipse.equinox.p2.operations.Update;
import org.eclipse.equinox.p2.operations.UpdateOperation;
import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Reference;
import org.robotui.api.config.UserFolder;
import org.robotui.install.FeatureInstaller;
import org.robotui.install.InstallOutcome;
import org.robotui.install.InstallOutcome.Changed;
import org.robotui.install.InstallOutcome.Reason;
import org.robotui.install.InstallOutcome.Refused;
import org.robotui.install.InstallOutcome.Unchanged;
import org.robotui.install.InstallWatcher;
import org.robotui.install.SiteContent;
import org.robotui.install.SiteFeature;

/** Installs by p2: its planner finds out what is needed, its engine takes back what fails halfway. */
@Component
public final class P2Installer implements FeatureInstaller {
  private static final InstallWatcher NOBODY = new InstallWatcher() {
    @Override
    public boolean acceptsUnsigned(List<String> names) {
      return false;
    }

    @Override
    public void step(String what) {
      // Nobody follows it.
    }
  };

  private final IProvisioningAgentProvider agents;
  private final LiveInstallation live;
  private final KnownSites sites = new KnownSites(UserFolder.state(System.getProperties(), System.getenv()));

  /** Called by declarative services. */
  @Activate
  public P2Installer(@Reference IProvisioningAgentProvider agents, @Reference LiveInstallation live) {
    this.agents = agents;
    this.live = live;
  }

  private P2Work work() throws ProvisionException {
    return new P2Work(agents.createAgent(null)); // that of the product that runs
  }

  @Override
  public synchronized List<SiteFeature> installed() {
    try (P2Work work = work()) {
      return work.features();
    } catch (ProvisionException e) {
      return List.of();
    }
  }

  @Override
  public synchronized SiteContent look(URI site) {
    try (P2Work work = work()) {
      work.give(UIServices.class, new TrustPrompt(NOBODY));
      return new SiteContent.Offered(P2Work.features(work.offered(site, new StepMonitor(NOBODY))));
    } catch (ProvisionException e) {
      return new SiteContent.Unreadable(unreachable(site, e));
    }
  }

  @Override
  public synchronized InstallOutcome install(URI site, List<String> features, InstallWatcher watcher) {
    try (P2Work work = work()) {
      List<IInstallableUnit> offered;
      try {
        offered = work.offered(site, new StepMonitor(watcher));
      } catch (ProvisionException e) {
        return new Refused(Reason.UNREACHABLE, unreachable(site, e));
      }
      List<IInstallableUnit> wanted = offered.stream().filter(unit -> features.contains(P2Work.id(unit))).toList();
      Set<String> unknown = missing(features, wanted);
      if (!unknown.isEmpty()) {
        return new Refused(Reason.UNKNOWN_FEATURE, site + " has no feature " + String.join(", ", unknown)
            + ". It has: " + names(offered) + ".");
      }
      if (work.roots().containsAll(wanted)) {
        return new Unchanged("It is installed already, in the version that the site has: " + names(wanted) + ".");
      }
      Set<URI> from = new LinkedHashSet<>(List.of(site));
      from.addAll(sites.all());
      InstallOutcome outcome = change(work, new InstallOperation(work.session(), wanted), from, watcher);
      if (outcome instanceof Changed) {
        sites.add(site);
      }
      return outcome;
    } catch (ProvisionException e) {
      return failed(e.getStatus());
    }
  }

  @Override
  public synchronized InstallOutcome update(List<String> features, InstallWatcher watcher) {
    try (P2Work work = work()) {
      List<IInstallableUnit> roots = features.isEmpty() ? List.copyOf(work.roots()) : work.roots(features);
      Set<String> unknown = missing(features, roots);
      if (!unknown.isEmpty()) {
        return notInstalled(unknown, work);
      }
      List<URI> reachable = new ArrayList<>();
      List<String> unreachable = new ArrayList<>();
      for (URI site : sites.all()) {
        try {
          work.offered(site, new StepMonitor(watcher));
          reachable.add(site);
        } catch (ProvisionException e) {
          unreachable.add(unreachable(site, e));
        }
      }
      if (reachable.isEmpty()) {
        return unreachable.isEmpty()
            ? new Unchanged("No update site is known: add one, or install something from it.")
            : new Refused(Reason.UNREACHABLE, String.join(" ", unreachable));
      }
      UpdateOperation operation = new UpdateOperation(work.session(), roots);
      operation.setProvisioningContext(work.context(reachable));
      IStatus resolved = operation.resolveModal(new StepMonitor(watcher));
      if (resolved.getCode() == UpdateOperation.STATUS_NOTHING_TO_UPDATE
          || operation.getPossibleUpdates().length == 0) {
        unreachable.addFirst("There is nothing newer.");
        return new Unchanged(String.join(" ", unreachable));
      }
      operation.setSelectedUpdates(newest(operation.getPossibleUpdates()));
      return change(work, operation, reachable, watcher);
    } catch (ProvisionException e) {
      return failed(e.getStatus());
    }
  }

  @Override
  public synchronized InstallOutcome remove(List<String> features, InstallWatcher watcher) {
    try (P2Work work = work()) {
      List<IInstallableUnit> units = work.roots(features);
      Set<String> unknown = missing(features, units);
      return unknown.isEmpty()
          ? change(work, new UninstallOperation(work.session(), units), List.of(), watcher)
          : notInstalled(unknown, work);
    } catch (ProvisionException e) {
      return failed(e.getStatus());
    }
  }

  @Override
  public List<URI> sites() {
    return sites.all();
  }

  @Override
  public void remember(URI site) {
    sites.add(site);
  }

  @Override
  public void forget(URI site) {
    sites.remove(site);
  }

  private InstallOutcome change(P2Work work, ProfileChangeOperation operation, Iterable<URI> from,
      InstallWatcher watcher) {
    if (work.profile().isEmpty()) {
      return new Refused(Reason.FAILED, "This RobotUI was not made by an installer, so that nothing can be installed.");
    }
    TrustPrompt trust = new TrustPrompt(watcher);
    work.give(UIServices.class, trust);
    List<SiteFeature> before = work.features();
    List<URI> sources = new ArrayList<>();
    from.forEach(sources::add);
    operation.setProvisioningContext(work.context(sources));
    IStatus resolved = operation.resolveModal(new StepMonitor(watcher));
    if (resolved.getSeverity() >= IStatus.ERROR || operation.getProvisioningPlan() == null) {
      IStatus reasons =
          operation.getProvisioningPlan() == null ? resolved : operation.getProvisioningPlan().getStatus();
      return new Refused(Reason.CONFLICT, PlanConflict.sentence(reasons.isOK() ? resolved : reasons));
    }
    IStatus done = operation.getProvisioningJob(new StepMonitor(watcher)).runModal(new StepMonitor(watcher));
    if (trust.declined()) {
      return new Refused(Reason.UNSIGNED, "Nothing was installed, as it is not signed.");
    }
    return done.getSeverity() >= IStatus.ERROR || done.matches(IStatus.CANCEL) ? failed(done) : applied(before, work);
  }

  private InstallOutcome applied(List<SiteFeature> before, P2Work work) {
    String sentence = P2Work.difference(before, work.features());
    try {
      boolean restart = live.apply();
      return new Changed(restart ? sentence + " It takes effect when RobotUI is started again." : sentence, restart);
    } catch (IOException e) {
      return new Changed(sentence + " It takes effect when RobotUI is started again (" + e.getMessage() + ").", true);
    }
  }

  private static InstallOutcome failed(IStatus status) {
    return Damage.in(status).<InstallOutcome>map(sentence -> new Refused(Reason.DAMAGED, sentence))
        .orElseGet(() -> new Refused(Reason.FAILED, "Nothing was changed. " + PlanConflict.sentence(status)));
  }

  private static Refused notInstalled(Set<String> unknown, P2Work work) {
    return new Refused(Reason.UNKNOWN_FEATURE, String.join(", ", unknown) + " is not installed. Installed are: "
        + names(work.roots()) + ".");
  }

  private static Set<String> missing(List<String> features, List<IInstallableUnit> found) {
    Set<String> missing = new TreeSet<>(features);
    found.forEach(unit -> missing.remove(P2Work.id(unit)));
    return missing;
  }

  private static String names(Iterable<IInstallableUnit> units) {
    Set<String> names = new TreeSet<>();
    units.forEach(unit -> names.add(P2Work.id(unit)));
    return names.isEmpty() ? "nothing" : String.join(", ", names);
  }

  /** Of several versions of one unit the last. */
  private static Update[] newest(Update[] possible) {
    Set<Update> chosen = new HashSet<>();
    for (Update update : possible) {
      boolean isNewest = Stream.of(possible).filter(other -> other.toUpdate.equals(update.toUpdate))
          .allMatch(other -> other.replacement.getVersion().compareTo(update.replacement.getVersion()) <= 0);
      if (isNewest) {
        chosen.add(update);
      }
    }
    return chosen.toArray(Update[]::new);
  }

  private static String unreachable(URI site, ProvisionException failure) {
    return switch (failure.getStatus().getCode()) {
      case ProvisionException.REPOSITORY_NOT_FOUND -> "There is no update site at " + site
          + ". It is a folder that has a file such as content.jar or p2.index.";
      case ProvisionException.REPOSITORY_FAILED_AUTHENTICATION -> site
          + " asks for a password, which is not supported.";
      default -> site + " cannot be read: " + PlanConflict.sentence(failure.getStatus());
    };
  }
}
