package org.robotui.architecture.tests;

import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.ImportTree;
import com.sun.source.tree.MemberSelectTree;
import com.sun.source.tree.Tree;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreeScanner;
import com.sun.source.util.Trees;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;

/** The syntax tree of a source, from the JDK's own parser: comments and strings cannot deceive it. */
record ParsedSource(CompilationUnitTree unit, Trees trees) {

  static ParsedSource of(SourceFile source) {
    JavacTask task = (JavacTask) ToolProvider.getSystemJavaCompiler()
        .getTask(null, null, diagnostic -> {}, List.of("-proc:none"), null, List.of(fileObject(source)));
    try {
      return new ParsedSource(task.parse().iterator().next(), Trees.instance(task));
    } catch (IOException e) {
      throw new UncheckedIOException(source.where(), e);
    }
  }

  String packageName() {
    return unit.getPackageName() == null ? "" : unit.getPackageName().toString();
  }

  /** All qualified names in imports and code, as written. */
  Set<String> qualifiedNames() {
    Set<String> names = new TreeSet<>();
    new TreeScanner<Void, Void>() {
      @Override
      public Void visitImport(ImportTree node, Void none) {
        names.add(node.getQualifiedIdentifier().toString());
        return null;
      }

      @Override
      public Void visitMemberSelect(MemberSelectTree node, Void none) {
        String name = node.toString();
        if (name.matches("[\\w.]+")) {
          names.add(name);
          return null;
        }
        return super.visitMemberSelect(node, none);
      }
    }.scan(withoutPackage(), null);
    return names;
  }

  private List<Tree> withoutPackage() {
    List<Tree> parts = new ArrayList<>(unit.getImports());
    parts.addAll(unit.getTypeDecls());
    return parts;
  }

  private static JavaFileObject fileObject(SourceFile source) {
    return new SimpleJavaFileObject(URI.create("string:///" + source.fileName()), JavaFileObject.Kind.SOURCE) {
      @Override
      public CharSequence getCharContent(boolean ignoreEncodingErrors) {
        return source.text();
      }
    };
  }
}
