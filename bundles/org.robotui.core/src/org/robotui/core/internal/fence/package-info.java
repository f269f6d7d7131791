/** Keeps what foreign code throws from ending more than its own component. Knows nothing else of core. */
package org.robotui.core.internal.fence;
