package org.robotui.tests.eclipse;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.eclipse.core.resources.IMarker;
import org.eclipse.core.resources.IProject;
import org.eclipse.core.resources.IProjectDescription;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.resources.IWorkspace;
import org.eclipse.core.resources.IncrementalProjectBuilder;
import org.eclipse.core.resources.ResourcesPlugin;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.IPath;
import org.eclipse.core.runtime.IProgressMonitor;
import org.eclipse.core.runtime.IStatus;
import org.eclipse.core.runtime.NullProgressMonitor;
import org.eclipse.core.runtime.Platform;
import org.eclipse.core.variables.VariablesPlugin;
import org.eclipse.equinox.app.IApplication;
import org.eclipse.equinox.app.IApplicationContext;
import org.eclipse.jdt.core.IClasspathContainer;
import org.eclipse.jdt.core.IClasspathEntry;
import org.eclipse.jdt.core.IJavaProject;
import org.eclipse.jdt.core.JavaCore;
import org.eclipse.pde.core.target.ITargetDefinition;
import org.eclipse.pde.core.target.ITargetLocation;
import org.eclipse.pde.core.target.ITargetPlatformService;
import org.eclipse.pde.core.target.LoadTargetDefinitionJob;
import org.osgi.framework.BundleContext;

/**
 * Does without a window what a user of Eclipse does with a folder of projects: sets their target platform, imports and
 * builds them, and looks at the problems and at the variables of their launch configurations.
 *
 * <p>Arguments: the folder, and one with the bundles of JUnit. Prints a line for each problem and one for what was
 * done; ends with 1 where there are problems.
 */
public final class ProjectBuild implements IApplication {
  private static final IPath JUNIT = IPath.fromOSString("org.eclipse.jdt.junit.JUNIT_CONTAINER/5");
  private static final int DEPTH = 3;

  private final IProgressMonitor quiet = new NullProgressMonitor();
  private final List<String> problems = new ArrayList<>();

  @Override
  public Object start(IApplicationContext context) throws Exception {
    String[] arguments = (String[]) context.getArguments().get(IApplicationContext.APPLICATION_ARGS);
    Path folder = Path.of(arguments[0]);
    Path junit = Path.of(arguments[1]);
    int bundles = setTarget(folder.resolve("robotui.target"), junit);
    List<IProject> projects = imported(folder);
    giveJunit(projects, junit);
    ResourcesPlugin.getWorkspace().build(IncrementalProjectBuilder.FULL_BUILD, quiet);
    lookAtMarkers();
    List<Path> launches = files(folder, ".launch");
    for (Path launch : launches) {
      lookAtLaunch(launch);
    }
    problems.forEach(System.out::println);
    System.out
        .println("projects: " + projects.size() + ", bundles in the target: " + bundles + ", launch configurations: "
            + launches.size() + ", problems: " + problems.size());
    ResourcesPlugin.getWorkspace().save(true, quiet);
    return problems.isEmpty() ? EXIT_OK : Integer.valueOf(1);
  }

  @Override
  public void stop() {}

  private static List<Path> files(Path folder, String ending) throws IOException {
    try (Stream<Path> files = Files.walk(folder, DEPTH)) {
      return files.filter(file -> file.getFileName().toString().endsWith(ending)).sorted().toList();
    }
  }

  /** Locations of Maven need a part of m2e that is on no registry of Maven's: the bundles of JUnit stand for them. */
  private int setTarget(Path file, Path junit) throws CoreException, InterruptedException {
    BundleContext context = Platform.getBundle("org.eclipse.pde.core").getBundleContext();
    ITargetPlatformService service = context.getService(context.getServiceReference(ITargetPlatformService.class));
    ITargetDefinition target = service.getTarget(file.toUri()).getTargetDefinition();
    List<ITargetLocation> locations = new ArrayList<>(List.of(target.getTargetLocations()));
    locations.removeIf(location -> location.getType().equals("Maven"));
    locations.add(service.newDirectoryLocation(junit.toString()));
    target.setTargetLocations(locations.toArray(ITargetLocation[]::new));
    report(target.resolve(quiet));
    service.saveTargetDefinition(target);
    LoadTargetDefinitionJob job = new LoadTargetDefinitionJob(target);
    job.schedule();
    job.join();
    report(job.getResult());
    return target.getBundles().length;
  }

  private void report(IStatus status) {
    if (!status.isOK()) {
      problems.add("error in the target platform: " + status.getMessage());
      Arrays.stream(status.getChildren()).forEach(this::report);
    }
  }

  private List<IProject> imported(Path folder) throws IOException, CoreException {
    IWorkspace workspace = ResourcesPlugin.getWorkspace();
    List<IProject> projects = new ArrayList<>();
    for (Path file : files(folder, ".project")) {
      IProjectDescription description = workspace.loadProjectDescription(IPath.fromPath(file));
      IProject project = workspace.getRoot().getProject(description.getName());
      project.create(description, quiet);
      project.open(quiet);
      projects.add(project);
    }
    return projects;
  }

  private void giveJunit(List<IProject> projects, Path junit) throws CoreException, IOException {
    IClasspathEntry[] entries = files(junit, ".jar").stream()
        .map(jar -> JavaCore.newLibraryEntry(IPath.fromPath(jar), null, null)).toArray(IClasspathEntry[]::new);
    List<IJavaProject> java = new ArrayList<>();
    for (IProject project : projects) {
      if (project.hasNature(JavaCore.NATURE_ID)) {
        java.add(JavaCore.create(project));
      }
    }
    IClasspathContainer[] containers = new IClasspathContainer[java.size()];
    Arrays.fill(containers, new Libraries(entries));
    JavaCore.setClasspathContainer(JUNIT, java.toArray(IJavaProject[]::new), containers, quiet);
  }

  /** In the place of JUnit's container, whose bundle is on no registry of Maven's either. */
  private record Libraries(IClasspathEntry[] entries) implements IClasspathContainer {
    @Override
    public IClasspathEntry[] getClasspathEntries() {
      return entries;
    }

    @Override
    public String getDescription() {
      return "JUnit and the annotations of components";
    }

    @Override
    public int getKind() {
      return K_APPLICATION;
    }

    @Override
    public IPath getPath() {
      return JUNIT;
    }
  }

  private void lookAtMarkers() throws CoreException {
    for (IMarker marker : ResourcesPlugin.getWorkspace().getRoot().findMarkers(IMarker.PROBLEM, true,
        IResource.DEPTH_INFINITE)) {
      int severity = marker.getAttribute(IMarker.SEVERITY, IMarker.SEVERITY_INFO);
      if (severity != IMarker.SEVERITY_INFO) {
        problems
            .add((severity == IMarker.SEVERITY_ERROR ? "error in " : "warning in ") + marker.getResource().getFullPath()
                + ":" + marker.getAttribute(IMarker.LINE_NUMBER, 0) + ": " + marker.getAttribute(IMarker.MESSAGE, ""));
      }
    }
  }

  /** As Eclipse does before it starts one. */
  private void lookAtLaunch(Path file) throws IOException {
    try {
      VariablesPlugin.getDefault().getStringVariableManager().validateStringVariables(Files.readString(file));
      VariablesPlugin.getDefault().getStringVariableManager().performStringSubstitution(Files.readString(file));
    } catch (CoreException e) {
      problems.add("error in " + file.getFileName() + ": " + e.getMessage());
    }
  }
}
