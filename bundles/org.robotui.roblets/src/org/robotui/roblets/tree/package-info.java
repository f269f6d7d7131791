/**
 * Messages as immutable XML trees: how they are read, written, asked by paths, and made of records. Nothing here starts
 * a thread or blocks; all of it is safe for all threads. What is read is bounded, and has no document type.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.roblets.tree;
