/** What a configuration says, and the seam between the reader of files and the rest of core. */
package org.robotui.core.internal.config.model;
