package org.robotui.workbench.internal.model;

import java.net.URI;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.robotui.install.FeatureInstaller;
import org.robotui.install.InstallOutcome;
import org.robotui.install.InstallWatcher;
import org.robotui.install.SiteContent;
import org.robotui.install.SiteFeature;

/** Features in memory. Nobody has signed them. */
public final class FakeInstaller implements FeatureInstaller {
  /** What it says where the user does not agree. */
  public static final String NOT_SIGNED = "Nothing was installed, as it is not signed.";

  private final Map<String, SiteFeature> installed = new TreeMap<>();
  private final Map<URI, List<SiteFeature>> offered = new TreeMap<>();
  private final Set<URI> sites = new LinkedHashSet<>();
  private final List<String> calls = new ArrayList<>();

  /** Has features. */
  public FakeInstaller installs(SiteFeature... features) {
    for (SiteFeature feature : features) {
      installed.put(feature.id(), feature);
    }
    return this;
  }

  /** Knows a site. */
  public FakeInstaller offers(URI site, SiteFeature... features) {
    offered.put(site, List.of(features));
    return this;
  }

  /** What was asked of it beside what is installed. */
  public List<String> calls() {
    return calls;
  }

  @Override
  public List<SiteFeature> installed() {
    return List.copyOf(installed.values());
  }

  @Override
  public SiteContent look(URI site) {
    calls.add("look");
    return offered.containsKey(site) ? new SiteContent.Offered(offered.get(site))
        : new SiteContent.Unreadable("There is no update site at " + site + ".");
  }

  @Override
  public InstallOutcome install(URI site, List<String> features, InstallWatcher watcher) {
    calls.add("install");
    watcher.step("Fetching");
    if (!watcher.acceptsUnsigned(List.of("lidar.jar"))) {
      return new InstallOutcome.Refused(InstallOutcome.Reason.UNSIGNED, NOT_SIGNED);
    }
    offered.get(site).stream().filter(f -> features.contains(f.id())).forEach(this::installs);
    return new InstallOutcome.Changed("Installed.", false);
  }

  @Override
  public InstallOutcome update(List<String> features, InstallWatcher watcher) {
    calls.add("update");
    return new InstallOutcome.Unchanged("There is nothing newer.");
  }

  @Override
  public InstallOutcome remove(List<String> features, InstallWatcher watcher) {
    calls.add("remove");
    features.forEach(installed::remove);
    return new InstallOutcome.Changed("Removed.", false);
  }

  @Override
  public List<URI> sites() {
    return List.copyOf(sites);
  }

  @Override
  public void remember(URI site) {
    sites.add(site);
  }

  @Override
  public void forget(URI site) {
    sites.remove(site);
  }
}
