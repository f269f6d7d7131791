/**
 * Connections that carry frames: {@link org.robotui.net.link.FrameLink} reads and writes them on two threads, and
 * sending never blocks.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.net.link;
