package org.robotui.install.internal;

import java.net.URI;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.eclipse.core.runtime.IProgressMonitor;
import org.eclipse.equinox.p2.core.IProvisioningAgent;
import org.eclipse.equinox.p2.core.ProvisionException;
import org.eclipse.equinox.p2.engine.IProfile;
import org.eclipse.equinox.p2.engine.IProfileRegistry;
import org.eclipse.equinox.p2.engine.ProvisioningContext;
import org.eclipse.equinox.p2.engine.query.UserVisibleRootQuery;
import org.eclipse.equinox.p2.metadata.IInstallableUnit;
import org.eclipse.equinox.p2.operations.ProvisioningSession;
import org.eclipse.equinox.p2.query.QueryUtil;
import org.eclipse.equinox.p2.repository.metadata.IMetadataRepository;
import org.eclipse.equinox.p2.repository.metadata.IMetadataRepositoryManager;
import org.robotui.install.SiteFeature;

/**
 * One piece of work with an agent of its own: an agent keeps in memory what it knows of a profile, and would not see
 * what another process has changed since.
 */
final class P2Work implements AutoCloseable {
  /** What stands behind the id of a feature in that of its unit. */
  static final String SUFFIX = ".feature.group";

  private final IProvisioningAgent agent;

  P2Work(IProvisioningAgent agent) {
    this.agent = agent;
  }

  @Override
  public void close() {
    agent.stop();
  }

  <S> void give(Class<S> type, S service) {
    agent.registerService(type.getName(), service);
  }

  ProvisioningSession session() {
    return new ProvisioningSession(agent);
  }

  /** What is installed; none where the product was not made by p2. */
  Optional<IProfile> profile() {
    return Optional.ofNullable(agent.getService(IProfileRegistry.class).getProfile(IProfileRegistry.SELF));
  }

  /** The units that users asked for. */
  Set<IInstallableUnit> roots() {
    return profile().map(profile -> profile.query(new UserVisibleRootQuery(), null).toUnmodifiableSet())
        .orElse(Set.of());
  }

  /** Those of the installed units that have one of the ids of features. */
  List<IInstallableUnit> roots(Collection<String> ids) {
    return roots().stream().filter(unit -> ids.contains(id(unit))).toList();
  }

  List<SiteFeature> features() {
    return features(roots());
  }

  /**
   * The newest versions of the features of a site.
   *
   * @throws ProvisionException when the site cannot be read
   */
  List<IInstallableUnit> offered(URI site, IProgressMonitor monitor) throws ProvisionException {
    IMetadataRepositoryManager manager = agent.getService(IMetadataRepositoryManager.class);
    boolean known = manager.contains(site);
    try {
      IMetadataRepository repository = manager.loadRepository(site, monitor);
      return repository.query(QueryUtil.createLatestQuery(QueryUtil.createIUGroupQuery()), monitor)
          .toUnmodifiableSet().stream().filter(unit -> unit.getId().endsWith(SUFFIX)).toList();
    } finally {
      if (!known) {
        manager.removeRepository(site); // p2 would look at it for other purposes as well
      }
    }
  }

  ProvisioningContext context(Collection<URI> sites) {
    ProvisioningContext context = new ProvisioningContext(agent);
    URI[] all = sites.toArray(URI[]::new);
    context.setMetadataRepositories(all);
    context.setArtifactRepositories(all);
    return context;
  }

  static List<SiteFeature> features(Collection<IInstallableUnit> units) {
    List<SiteFeature> features = new ArrayList<>();
    units.stream().filter(unit -> unit.getId().endsWith(SUFFIX)).map(P2Work::feature).forEach(features::add);
    features
        .sort(Comparator.comparing(SiteFeature::name, String.CASE_INSENSITIVE_ORDER).thenComparing(SiteFeature::id));
    return List.copyOf(features);
  }

  static String id(IInstallableUnit unit) {
    String id = unit.getId();
    return id.endsWith(SUFFIX) ? id.substring(0, id.length() - SUFFIX.length()) : id;
  }

  private static SiteFeature feature(IInstallableUnit unit) {
    return new SiteFeature(id(unit), unit.getVersion().toString(),
        name(unit),
        text(unit, IInstallableUnit.PROP_DESCRIPTION).orElse(""));
  }

  /** What it is called, else its id. */
  static String name(IInstallableUnit unit) {
    return text(unit, IInstallableUnit.PROP_NAME).orElse(id(unit));
  }

  private static Optional<String> text(IInstallableUnit unit, String property) {
    return Optional.ofNullable(unit.getProperty(property, null));
  }

  /** What has come and gone between two states, in sentences. */
  static String difference(List<SiteFeature> before, List<SiteFeature> after) {
    TreeMap<String, SiteFeature> old = byId(before);
    TreeMap<String, SiteFeature> now = byId(after);
    List<String> sentences = new ArrayList<>();
    now.forEach((id, feature) -> {
      SiteFeature former = old.get(id);
      if (former == null) {
        sentences.add("Installed " + feature.label() + ".");
      } else if (!former.version().equals(feature.version())) {
        sentences.add("Updated " + feature.name() + " from " + former.version() + " to " + feature.version() + ".");
      }
    });
    old.forEach((id, feature) -> {
      if (!now.containsKey(id)) {
        sentences.add("Removed " + feature.label() + ".");
      }
    });
    return String.join(" ", sentences);
  }

  private static TreeMap<String, SiteFeature> byId(List<SiteFeature> features) {
    return features.stream().collect(Collectors.toMap(SiteFeature::id, f -> f, (a, b) -> b, TreeMap::new));
  }
}
